"""A house: gabled roofs, windows with frames and bars, a porch, steps, a chimney.

Built of flat polygons, in parts that differ in material and identity. One unit is a metre.
"""

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
    _wing(parts, (-3.0, 3.0), (-2.0, 2.0), eaves=3.4, ridge=5.2, along=0)
    _wing(parts, (0.6, 2.8), (1.0, 3.4), eaves=3.4, ridge=4.9, along=2)
    _box(parts["stone"], (-2.0, 3.6, -0.8), (-1.3, 6.0, -0.2))  # chimney
    _box(parts["stone"], (-2.1, 6.0, -0.9), (-1.2, 6.15, -0.1))
    _box(parts["stone"], (-3.15, 0.0, -2.15), (3.15, 0.45, 2.15))  # plinth
    _box(parts["stone"], (0.5, 0.0, 0.9), (2.9, 0.45, 3.5))
    for x in (-2.45, 0.0):
        _window(parts, x, 1.0, 2.0, width=0.8, height=1.2, facing=2)
    for x in (-2.2, -1.1, 0.0):
        _window(parts, x, 2.55, 2.0, width=0.7, height=0.7, facing=2)
    _window(parts, 1.7, 1.0, 3.4, width=1.1, height=1.3, facing=2)
    _window(parts, 1.7, 3.15, 3.4, width=0.5, height=0.7, facing=2)
    for z in (-1.1, 0.6):
        _window(parts, z, 1.0, 3.0, width=0.8, height=1.2, facing=0)
        _window(parts, z, 2.55, 3.0, width=0.7, height=0.7, facing=0)
    _window(parts, 2.2, 1.0, 2.8, width=0.9, height=1.2, facing=0)
    _porch(parts)
    return {name: polygons(faces) for name, faces in parts.items()}


def ground(half=150.0):
    """The lawn around it."""
    corners = [(-half, 0, half), (half, 0, half), (half, 0, -half), (-half, 0, -half)]
    return backdrop(corners)


def _box(faces, low, high):
    (x0, y0, z0), (x1, y1, z1) = low, high
    faces += [
        [(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)],
        [(x1, y0, z0), (x0, y0, z0), (x0, y1, z0), (x1, y1, z0)],
        [(x1, y0, z1), (x1, y0, z0), (x1, y1, z0), (x1, y1, z1)],
        [(x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (x0, y1, z0)],
        [(x0, y1, z1), (x1, y1, z1), (x1, y1, z0), (x0, y1, z0)],
        [(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)],
    ]


def _swapped(faces):
    """Polygons with x and z exchanged, still counter-clockwise from outside."""
    return [[(z, y, x) for x, y, z in reversed(face)] for face in faces]


def _wing(parts, x, z, eaves, ridge, along, overhang=0.35, thickness=0.14):
    """Walls with a gabled roof whose ridge runs along an axis."""
    (length, across) = (x, z) if along == 0 else (z, x)
    (l0, l1), (a0, a1), middle = length, across, sum(across) / 2
    walls = [
        [(l0, 0, a1), (l1, 0, a1), (l1, eaves, a1), (l0, eaves, a1)],
        [(l1, 0, a0), (l0, 0, a0), (l0, eaves, a0), (l1, eaves, a0)],
        [(l1, 0, a1), (l1, 0, a0), (l1, eaves, a0), (l1, ridge, middle), (l1, eaves, a1)],
        [(l0, 0, a0), (l0, 0, a1), (l0, eaves, a1), (l0, ridge, middle), (l0, eaves, a0)],
    ]
    slope = (ridge - eaves) / (a1 - middle)
    low = eaves - slope * overhang
    l0, l1, a0, a1 = l0 - overhang, l1 + overhang, a0 - overhang, a1 + overhang
    t = thickness
    roof = []
    for outer in (a0, a1):
        slab = [(low + t, outer), (ridge + t, middle), (ridge, middle), (low, outer)]
        ends = [[(end, y, a) for y, a in slab] for end in (l0, l1)]
        if outer == a0:
            ends = ends[::-1]
        roof += [ends[0], ends[1][::-1]]
        for k in range(4):
            n = (k + 1) % 4
            roof.append([ends[0][n], ends[0][k], ends[1][k], ends[1][n]])
    parts["walls"] += walls if along == 0 else _swapped(walls)
    parts["roof"] += roof if along == 0 else _swapped(roof)


def _window(parts, middle, sill, plane, width, height, facing):
    """A framed window with one bar each way, on a wall that faces x (0) or z (2)."""
    glass, frames, stone = [], [], []
    left, right, top = middle - width / 2, middle + width / 2, sill + height
    out, bar = plane + 0.02, 0.07
    glass.append([(left, sill, out), (right, sill, out), (right, top, out), (left, top, out)])
    for low, high in (
        ((left - bar, sill - bar), (left, top + bar)),
        ((right, sill - bar), (right + bar, top + bar)),
        ((left, top), (right, top + bar)),
        ((left, sill - bar), (right, sill)),
        ((middle - 0.025, sill), (middle + 0.025, top)),
        ((left, sill + 0.6 * height), (right, sill + 0.6 * height + 0.05)),
    ):
        _box(frames, (*low, plane), (*high, plane + 0.08))
    _box(stone, (left - 0.15, sill - bar - 0.1, plane), (right + 0.15, sill - bar, plane + 0.18))
    for name, faces in (("glass", glass), ("frames", frames), ("stone", stone)):
        parts[name] += _swapped(faces) if facing == 0 else faces


def _porch(parts):
    """Door, steps with side walls, a small roof on two posts."""
    frames, stone, roof = parts["frames"], parts["stone"], parts["roof"]
    _box(frames, (-1.55, 0.45, 2.0), (-0.65, 2.35, 2.06))
    for y in (0.65, 1.45):
        _box(frames, (-1.4, y, 2.06), (-0.8, y + 0.6, 2.09))
    for step in range(_STEPS):
        rise, depth = 0.45 * (_STEPS - step) / _STEPS, 0.32 * (step + 1)
        _box(stone, (-1.75, 0.0, 2.15 + depth - 0.32 + 0.5), (-0.45, rise, 2.15 + depth + 0.5))
    _box(stone, (-1.75, 0.0, 2.0), (-0.45, 0.45, 2.65))
    for x in (-1.95, -0.45):
        _box(stone, (x, 0.0, 2.15), (x + 0.2, 0.62, 3.95))
        _box(frames, (x + 0.04, 0.62, 3.0), (x + 0.16, 2.5, 3.12))
    _box(roof, (-2.15, 2.5, 2.0), (-0.05, 2.62, 3.3))
