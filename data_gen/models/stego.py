"""Stegosaurus: an arched body, two rows of thin plates, a spiked tail."""

from itertools import pairwise

import numpy as np
from scipy.interpolate import make_interp_spline

from data_gen.models.mesh import standing, turned
from data_gen.models.sculpture import Sculpture, axes_of, ball, ellipsoid, limb, plate

# From the muzzle to the tip of the tail: x, y of the spine and radius of the trunk.
_TRUNK = np.array(
    [(-2.02, 0.62, 0.085), (-1.82, 0.70, 0.14), (-1.55, 0.78, 0.135), (-1.2, 0.92, 0.22),
     (-0.75, 1.10, 0.38), (-0.2, 1.28, 0.50), (0.35, 1.28, 0.46), (0.85, 1.10, 0.30),
     (1.35, 0.92, 0.17), (1.85, 0.86, 0.10), (2.3, 0.95, 0.035)]
)  # fmt: skip
_KITE = np.array([(-0.30, 0.0), (0.0, -0.32), (0.30, 0.0), (0.0, 0.60)])


def stego():
    clay = Sculpture((-2.4, -0.1, -0.9), (2.6, 2.6, 0.9))
    along = make_interp_spline(np.linspace(0, 1, len(_TRUNK)), _TRUNK, k=3)
    spine = along(np.linspace(0, 1, 45))
    for start, end in pairwise(spine):
        clay.join(limb((*start[:2], 0), (*end[:2], 0), start[2], end[2]), softness=0.03)
    _head(clay)
    for side in (-1, 1):
        _leg(clay, (-0.72, 0.95), (-0.80, 0.5), (-0.68, 0.1), side * 0.30, 0.19)
        _leg(clay, (0.42, 1.08), (0.28, 0.58), (0.52, 0.1), side * 0.32, 0.27)
        for share, size in zip(
            np.linspace(0.16, 0.86, 9) + 0.02 * side,
            (0.32, 0.5, 0.7, 0.95, 1.15, 1.1, 0.85, 0.55, 0.35),
            strict=True,
        ):
            _plate(clay, along, share, size, side)
        for share in (0.91, 0.965):
            x, y, radius = along(share)
            clay.join(
                limb((x, y, side * radius / 2), (x + 0.12, y + 0.30, side * 0.34), 0.05, 0.012),
                softness=0.03,
            )
    return standing(turned(clay.mesh(), 28), width=4.1)


def _head(clay):
    clay.join(limb((-2.02, 0.60, 0), (-2.12, 0.57, 0), 0.075, 0.05), softness=0.04)
    clay.cut(limb((-2.2, 0.575, 0), (-1.98, 0.60, 0), 0.012), softness=0.02)
    for side in (-1, 1):
        clay.join(ball((-1.88, 0.76, side * 0.11), 0.035), softness=0.02)
        clay.cut(ball((-2.1, 0.61, side * 0.05), 0.016), softness=0.01)


def _leg(clay, hip, knee, foot, z, radius):
    clay.join(ellipsoid((*hip, z), (radius * 1.2, radius * 1.4, radius * 0.8)), softness=0.15)
    clay.join(limb((*hip, z), (*knee, z * 1.25), radius, radius * 0.62), softness=0.1)
    clay.join(limb((*knee, z * 1.25), (*foot, z * 1.2), radius * 0.6, radius * 0.55), softness=0.06)
    for toe in (-1, 0, 1):
        start = (foot[0] - 0.02, 0.09, z * 1.2 + 0.07 * toe)
        clay.join(
            limb(start, (foot[0] - 0.17, 0.055, z * 1.2 + 0.1 * toe), 0.08, 0.05), softness=0.03
        )


def _plate(clay, along, share, size, side):
    x, y, radius = along(share)
    slope = along(share, nu=1)[:2]
    lean = np.array([0, 1, 0.35 * side])
    forward = np.array([*slope / np.linalg.norm(slope), 0])
    axes = axes_of(forward, lean)
    foot = np.array([x, y, 0]) + axes[1] * (radius + 0.05 * size) + [0, 0, 0.04 * side]
    clay.join(plate(size * _KITE, foot, axes, 0.07, rounding=0.03), softness=0.02)
