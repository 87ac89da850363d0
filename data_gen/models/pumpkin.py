"""Pumpkin: ribbed, carved with a face and hollow, with a bent stalk and a tendril."""

import numpy as np

from data_gen.models.mesh import standing, turned
from data_gen.models.sculpture import Sculpture, Shape, chain, limb, plate

_RIBS = 11
_RADIUS, _HEIGHT = 1.25, 0.98


def pumpkin():
    """Faces z."""
    clay = Sculpture((-1.6, -0.2, -1.6), (1.6, 3.0, 1.8))
    clay.join(_flesh(1.0))
    clay.cut(_flesh(0.84), softness=0.02)
    for outline, (x, y) in (
        ([(-0.26, -0.14), (0.22, -0.18), (0.02, 0.22)], (-0.45, 1.3)),
        ([(-0.22, -0.18), (0.26, -0.14), (-0.02, 0.22)], (0.45, 1.3)),
        ([(-0.1, -0.09), (0.1, -0.09), (0, 0.12)], (0.0, 1.0)),
    ):
        clay.cut(_hole(outline, x, y), softness=0.02)
    for k in range(7):  # a grin of slanted teeth
        x = 0.19 * (k - 3)
        width, low = 0.065, 0.62 + 0.055 * (k - 3) ** 2 / 3
        outline = [(-width, -0.12), (width, -0.12), (width + 0.05, 0.12), (-width - 0.05, 0.12)]
        clay.cut(_hole(outline, x, low if k % 2 else low - 0.08), softness=0.02)
    _stalk(clay)
    return standing(turned(clay.mesh(), -16), width=2.9)


def _flesh(share):
    """Eleven ribs: a radius that swells between the grooves, dimpled at the poles."""

    def distance(x, y, z):
        up = (y - _HEIGHT) / _HEIGHT
        around = np.arctan2(x, z)
        swell = 0.90 + 0.10 * np.abs(np.cos(_RIBS / 2 * around)) ** 0.7
        out = np.hypot(x, z) / _RADIUS
        to_unit = (
            np.abs(out / swell) ** 2.4 + np.abs(up / (0.86 + 0.14 * np.minimum(out * 2, 1))) ** 2.4
        ) ** (1 / 2.4)
        return (to_unit - share) * 0.75

    reach = np.array([_RADIUS, _HEIGHT, _RADIUS]) * share
    centre = np.array([0, _HEIGHT, 0])
    return Shape(distance, centre - reach, centre + reach)


def _hole(outline, x, y):
    """A prism through the front wall."""
    forward = np.array([x * 0.5, (y - _HEIGHT) * 0.2, 1.0])
    side = np.cross((0, 1, 0), forward)
    side /= np.linalg.norm(side)
    forward /= np.linalg.norm(forward)
    axes = np.array([side, np.cross(forward, side), forward])
    return plate(outline, (x, y, 1.0), axes, 1.1)


def _stalk(clay):
    joints = np.array([(0, 1.72, 0), (0.02, 1.98, 0.02), (0.12, 2.18, 0.06), (0.3, 2.32, 0.1)])
    for start, end, radius in zip(joints[:-1], joints[1:], (0.2, 0.13, 0.12), strict=True):
        clay.join(limb(start, end, radius, radius * 0.8), softness=0.06)
        for k in range(5):
            offset = 0.8 * radius * np.array([np.cos(k * 1.257), 0, np.sin(k * 1.257)])
            clay.join(limb(start + offset, end + 0.7 * offset, 0.05), softness=0.03)
    turns = np.linspace(0, 1, 60)[:, None]
    angle = 2 * np.pi * 2.6 * turns
    curl = np.concatenate(
        [
            -0.15 - 1.0 * turns,
            1.82 + 0.5 * turns + 0.14 * np.sin(angle),
            0.2 + 0.5 * turns + 0.14 * np.cos(angle),
        ],
        axis=1,
    )
    clay.join(chain(curl, [0.035] * len(curl)), softness=0.02)
