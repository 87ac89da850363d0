"""Helmet: a hollow dome with cheek guards, nose guard, rivets and two horns."""

import numpy as np

from data_gen.models.mesh import standing, turned
from data_gen.models.sculpture import Sculpture, ball, box, chain, ellipsoid, ring, shell, slab


def helmet():
    """Faces z."""
    clay = Sculpture((-2.3, -0.2, -1.4), (2.3, 3.1, 1.7))
    # neck and cheek guards, open at the face, then the dome
    clay.join(slab(shell(ellipsoid((0, 0.95, 0), (0.97, 1.5, 1.05)), 0.08), 0.15, 1.0))
    clay.cut(box((0, 0.4, 1.0), (0.40, 0.75, 0.9)), softness=0.06)
    clay.cut(ellipsoid((0, 0.75, 1.0), (0.62, 0.34, 0.6)), softness=0.06)
    clay.join(slab(shell(ellipsoid((0, 1.15, 0), (0.98, 1.12, 1.06)), 0.09), 0.9, 3.0))
    clay.join(ring((0, 0.98, 0), 1.0, 0.075), softness=0.03)
    for k in range(18):
        angle = 2 * np.pi * (k + 0.5) / 18
        clay.join(ball((1.07 * np.sin(angle), 0.98, 1.07 * np.cos(angle)), 0.05), softness=0.01)
    # ribs over the crown, and the nose guard
    angle = np.linspace(0, np.pi, 25)
    for around in ((0.0, 1.06), (0.98, 0.0)):
        arch = [
            (around[0] * np.cos(a), 1.15 + 1.12 * np.sin(a), around[1] * np.cos(a)) for a in angle
        ]
        clay.join(chain(arch, [0.065] * len(arch)), softness=0.03)
    clay.join(box((0, 0.68, 1.06), (0.1, 0.42, 0.045), rounding=0.03), softness=0.04)
    clay.join(ball((0, 2.33, 0), 0.13), softness=0.05)
    for side in (-1, 1):
        _horn(clay, side)
    return standing(turned(clay.mesh(), -24), height=2.75)


def _horn(clay, side):
    t = np.linspace(0, 1, 28)
    points = np.stack(
        [
            side * (0.86 + 1.05 * np.sin(1.25 * t) ** 0.9),
            1.45 + 0.15 * t + 1.25 * t**2.2,
            0.1 + 0.25 * t,
        ],
        axis=1,
    )
    radii = 0.25 * (1 - t) ** 0.8 + 0.02
    clay.join(chain(points, radii), softness=0.05)
    clay.join(ball(points[0], 0.31), softness=0.04)
