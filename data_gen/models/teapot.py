"""The Utah teapot from its 32 Bézier patches (Newell 1975).

Body, rim, lid and bottom are surfaces of revolution, each quarter one patch whose rows
follow a profile; handle and spout are pairs of patches mirrored at the plane of symmetry.
Their control points are the published ones.
"""

import numpy as np

from data_gen.models.mesh import Mesh, standing, turned

# Bézier control points of the profiles, (radius, height).
_PROFILES = (
    ((1.4, 2.4), (1.3375, 2.53125), (1.4375, 2.53125), (1.5, 2.4)),  # rim
    ((1.5, 2.4), (1.75, 1.875), (2.0, 1.35), (2.0, 0.9)),  # body
    ((2.0, 0.9), (2.0, 0.45), (1.5, 0.225), (1.5, 0.15)),
    ((0.0, 3.15), (0.8, 3.15), (0.0, 2.85), (0.2, 2.7)),  # lid
    ((0.2, 2.7), (0.4, 2.55), (1.3, 2.55), (1.3, 2.4)),
    ((1.5, 0.15), (1.5, 0.075), (1.425, 0.0), (0.0, 0.0)),  # bottom
)
_QUARTER = np.array([(1, 0), (1, 0.56), (0.56, 1), (0, 1)])

# Four rows of (x, height) at the inner edge, (x, height) at the outer edge, half width.
_TUBES = (
    ((-1.6, 2.025, -1.5, 2.25, 0.3), (-2.3, 2.025, -2.5, 2.25, 0.3),  # handle
     (-2.7, 2.025, -3.0, 2.25, 0.3), (-2.7, 1.8, -3.0, 1.8, 0.3)),
    ((-2.7, 1.8, -3.0, 1.8, 0.3), (-2.7, 1.575, -3.0, 1.35, 0.3),
     (-2.5, 1.125, -2.65, 0.9375, 0.3), (-2.0, 0.9, -1.9, 0.6, 0.3)),
    ((1.7, 1.425, 1.7, 0.6, 0.66), (2.6, 1.425, 3.1, 0.825, 0.66),  # spout
     (2.3, 2.1, 2.4, 2.025, 0.25), (2.7, 2.4, 3.3, 2.4, 0.25)),
    ((2.7, 2.4, 3.3, 2.4, 0.25), (2.8, 2.475, 3.525, 2.49375, 0.25),
     (2.9, 2.475, 3.45, 2.5125, 0.15), (2.8, 2.4, 3.2, 2.4, 0.15)),
)  # fmt: skip


def teapot(steps=48):
    """Spout to the right; ``steps`` squares along each side of a patch."""
    patches = [_evaluate(points, steps) for points in _control_points()]
    corner = np.arange((steps + 1) ** 2).reshape(steps + 1, steps + 1)
    square = np.stack([corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]], axis=-1)
    faces = np.concatenate([square[..., [0, 1, 2]], square[..., [0, 2, 3]]]).reshape(-1, 3)
    offsets = np.arange(len(patches))[:, None, None] * (steps + 1) ** 2
    vertices, normals = (np.concatenate([patch[k] for patch in patches]) for k in (0, 1))
    mesh = Mesh(
        vertices.astype(np.float32),
        (faces + offsets).reshape(-1, 3).astype(np.uint32),
        normals.astype(np.float32),
    )
    return standing(turned(mesh, -20), width=4.0)


def _control_points():
    """(4, 4, 3) arrays in the axes of the stage; one parameter turns so that all face outwards."""
    for profile in np.array(_PROFILES):
        for sign_x, sign_z in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
            points = np.empty((4, 4, 3))
            points[..., 0] = sign_x * profile[:, :1] * _QUARTER[:, 0]
            points[..., 1] = profile[:, 1:]
            points[..., 2] = sign_z * profile[:, :1] * _QUARTER[:, 1]
            yield points[:, :: -sign_x * sign_z]
    for rows in np.array(_TUBES):
        for side in (1, -1):
            points = np.empty((4, 4, 3))
            points[:, :2, :2] = rows[:, None, 0:2]
            points[:, 2:, :2] = rows[:, None, 2:4]
            points[..., 2] = side * rows[:, 4:] * (0, 1, 1, 0)
            yield points[:, ::-side]


def _evaluate(points, steps):
    """Positions and unit normals on a grid of parameters."""
    t = np.linspace(0, 1, steps + 1)
    inner = np.clip(t, 1e-4, 1 - 1e-4)  # at the poles a derivative vanishes
    value, at, slope = _bernstein(t), _bernstein(inner), _bernstein_slope(inner)
    position = np.einsum("ui,vj,ijk->uvk", value, value, points).reshape(-1, 3)
    normal = np.cross(
        np.einsum("ui,vj,ijk->uvk", slope, at, points),
        np.einsum("ui,vj,ijk->uvk", at, slope, points),
    ).reshape(-1, 3)
    return position, normal / np.linalg.norm(normal, axis=1, keepdims=True)


def _bernstein(t):
    """The four cubic Bernstein polynomials at each t, (N, 4)."""
    return np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3], axis=1)


def _bernstein_slope(t):
    lower = np.stack([(1 - t) ** 2, 2 * t * (1 - t), t**2], axis=1)
    zero = np.zeros((len(t), 1))
    return 3 * (np.hstack([zero, lower]) - np.hstack([lower, zero]))
