"""A chapel: a nave, a round apse, a round tower with a dome, and a thin cross that casts a shadow.

One unit is a metre. The light comes from the right, so that the cross' shadow lies on the roof.
"""

import numpy as np

from data_gen.models.masonry import box, swapped, wing
from data_gen.models.mesh import polygons
from data_gen.models.revolved import revolved, united

_TOWER = (2.5, 2.85)
_APSE = (-4.6, 0.0)
_CURVE = np.radians(np.linspace(0, 90, 25))


def chapel():
    """Front towards z.

    Returns
    -------
    dict of str to Mesh
        Parts: walls, roof, glass, stone, copper.
    """
    flat = {name: [] for name in ("walls", "roof", "glass", "stone", "copper")}
    wing(flat, (-4.6, 2.2), (-1.9, 1.9), eaves=3.1, ridge=5.1, along=0, overhang=0.25)
    box(flat["stone"], (-4.6, 0.0, -2.0), (2.3, 0.35, 2.0))
    for x in (-3.7, -2.3, -0.9):
        _arched_window(flat, x, 1.15, 1.9, width=0.6, height=1.1)
    _arched_window(flat, 0.65, 0.35, 1.9, width=0.95, height=1.45, pane="copper")
    for step in range(3):
        box(flat["stone"], (-0.1, 0.0, 1.9), (1.4, 0.35 - 0.1 * step, 2.5 + 0.3 * step))
    sideways = {name: [] for name in flat}
    _arched_window(sideways, 0.0, 1.3, 2.2, width=0.7, height=1.5)
    for name, faces in sideways.items():
        flat[name] += swapped(faces)
    _cross(flat["copper"], (*_TOWER, 6.55), height=1.15, arm=0.34, bar=0.045)
    rounded = _tower() | _apse()
    return {
        name: united(polygons(faces), [mesh for part, mesh in rounded.items() if part[0] == name])
        for name, faces in flat.items()
    }


def _tower():
    dome = [(1.12 * np.cos(t), 5.05 + 1.1 * np.sin(t)) for t in _CURVE[:-2]]
    belfry = [(angle, angle + 26) for angle in (2, 62, 122, 182, 242, 302)]
    pane = [(1.02, 3.75), (1.02, 4.55)]
    cornice = [(1.0, 4.8), (1.18, 4.8), (1.18, 5.0), (1.12, 5.05)]
    return {
        ("walls", "tower"): revolved([(1.0, 0.0), (1.0, 4.8)], _TOWER),
        ("stone", "foot"): revolved([(1.12, 0.0), (1.12, 0.4), (1.0, 0.4)], _TOWER),
        ("stone", "string"): revolved([(1.0, 3.3), (1.07, 3.3), (1.07, 3.45), (1.0, 3.45)], _TOWER),
        ("stone", "cornice"): revolved(cornice, _TOWER),
        ("copper", "dome"): revolved(dome, _TOWER, smooth=True),
        ("copper", "lantern"): revolved([(0.16, 6.1), (0.16, 6.4), (0.0, 6.6)], _TOWER),
        **{("glass", begin): revolved(pane, _TOWER, begin, end) for begin, end in belfry},
    }


def _apse():
    half = {"begin": 180.0, "end": 360.0}
    return {
        ("walls", "apse"): revolved([(1.6, 0.0), (1.6, 2.5)], _APSE, **half),
        ("stone", "apse foot"): revolved([(1.7, 0.0), (1.7, 0.35), (1.6, 0.35)], _APSE, **half),
        ("stone", "apse eaves"): revolved([(1.6, 2.45), (1.75, 2.5)], _APSE, **half),
        ("roof", "apse"): revolved([(1.75, 2.5), (0.0, 3.9)], _APSE, **half),
        **{
            ("glass", begin): revolved([(1.62, 1.15), (1.62, 2.05)], _APSE, begin, begin + 22)
            for begin in (199.0, 259.0, 319.0)
        },
    }


def _arched_window(parts, middle, sill, plane, width, height, pane="glass"):
    """A pane with a round head in a stone frame, on a wall that faces z."""
    spring, radius, bar = sill + height - width / 2, width / 2, 0.09
    turn = np.radians(np.linspace(0, 180, 13))
    head = [(middle + radius * np.cos(t), spring + radius * np.sin(t)) for t in turn]
    inner = [(middle + radius, sill), *head, (middle - radius, sill)]
    wide = (radius + bar) / radius
    outer = [
        (middle + (x - middle) * wide, max(sill, spring + (y - spring) * wide)) for x, y in inner
    ]
    parts[pane].append([(x, y, plane + 0.02) for x, y in inner])
    front = plane + 0.07
    for k in range(len(inner) - 1):
        (ax, ay), (bx, by), (cx, cy), (dx, dy) = outer[k], outer[k + 1], inner[k + 1], inner[k]
        parts["stone"] += [
            [(ax, ay, front), (bx, by, front), (cx, cy, front), (dx, dy, front)],
            [(ax, ay, plane), (bx, by, plane), (bx, by, front), (ax, ay, front)],
            [(dx, dy, front), (cx, cy, front), (cx, cy, plane), (dx, dy, plane)],
        ]
    box(
        parts["stone"],
        (middle - radius - 0.14, sill - 0.12, plane),
        (middle + radius + 0.14, sill, plane + 0.16),
    )


def _cross(faces, foot, height, arm, bar):
    """Two square bars, crossed at two thirds of the height; ``foot`` is x, z, y."""
    x, z, y = foot
    crossing = y + 0.68 * height
    box(faces, (x - bar, y, z - bar), (x + bar, y + height, z + bar))
    box(faces, (x - arm, crossing - bar, z - bar), (x - bar, crossing + bar, z + bar))
    box(faces, (x + bar, crossing - bar, z - bar), (x + arm, crossing + bar, z + bar))
