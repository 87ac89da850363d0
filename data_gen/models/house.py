"""A house: gabled roofs, windows with frames and bars, a porch, steps, a chimney.

Built of flat polygons, in parts that differ in material and identity. One unit is a metre.
"""

from data_gen.models.masonry import box, window, wing
from data_gen.models.mesh import backdrop, polygons

_STEPS = 4


def house():
    """Front towards z.

    Returns
    -------
    dict of str to Mesh
        Parts: walls, roof, glass, frames, stone.
    """
    parts = {name: [] for name in ("walls", "roof", "glass", "frames", "stone")}
    wing(parts, (-3.0, 3.0), (-2.0, 2.0), eaves=3.4, ridge=5.2, along=0)
    wing(parts, (0.6, 2.8), (1.0, 3.4), eaves=3.4, ridge=4.9, along=2)
    box(parts["stone"], (-2.0, 3.6, -0.8), (-1.3, 6.0, -0.2))  # chimney
    box(parts["stone"], (-2.1, 6.0, -0.9), (-1.2, 6.15, -0.1))
    box(parts["stone"], (-3.15, 0.0, -2.15), (3.15, 0.45, 2.15))  # plinth
    box(parts["stone"], (0.5, 0.0, 0.9), (2.9, 0.45, 3.5))
    for x in (-2.45, 0.0):
        window(parts, x, 1.0, 2.0, width=0.8, height=1.2, facing=2)
    for x in (-2.2, -1.1, 0.0):
        window(parts, x, 2.55, 2.0, width=0.7, height=0.7, facing=2)
    window(parts, 1.7, 1.0, 3.4, width=1.1, height=1.3, facing=2)
    window(parts, 1.7, 3.15, 3.4, width=0.5, height=0.7, facing=2)
    for z in (-1.1, 0.6):
        window(parts, z, 1.0, 3.0, width=0.8, height=1.2, facing=0)
        window(parts, z, 2.55, 3.0, width=0.7, height=0.7, facing=0)
    window(parts, 2.2, 1.0, 2.8, width=0.9, height=1.2, facing=0)
    _porch(parts)
    return {name: polygons(faces) for name, faces in parts.items()}


def ground(half=150.0):
    """The lawn around it."""
    corners = [(-half, 0, half), (half, 0, half), (half, 0, -half), (-half, 0, -half)]
    return backdrop(corners)


def _porch(parts):
    """Door, steps with side walls, a small roof on two posts."""
    frames, stone, roof = parts["frames"], parts["stone"], parts["roof"]
    box(frames, (-1.55, 0.45, 2.0), (-0.65, 2.35, 2.06))
    for y in (0.65, 1.45):
        box(frames, (-1.4, y, 2.06), (-0.8, y + 0.6, 2.09))
    for step in range(_STEPS):
        rise, depth = 0.45 * (_STEPS - step) / _STEPS, 0.32 * (step + 1)
        box(stone, (-1.75, 0.0, 2.15 + depth - 0.32 + 0.5), (-0.45, rise, 2.15 + depth + 0.5))
    box(stone, (-1.75, 0.0, 2.0), (-0.45, 0.45, 2.65))
    for x in (-1.95, -0.45):
        box(stone, (x, 0.0, 2.15), (x + 0.2, 0.62, 3.95))
        box(frames, (x + 0.04, 0.62, 3.0), (x + 0.16, 2.5, 3.12))
    box(roof, (-2.15, 2.5, 2.0), (-0.05, 2.62, 3.3))
