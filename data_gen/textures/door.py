"""A wall with one door: a structure of the whole picture, which patches cannot keep."""

import numpy as np

from data_gen.textures.bricks import wall
from data_gen.textures.noise import picture, smooth_noise

_SANDSTONE, _FRAME, _WOOD, _HANDLE = (186, 160, 122), (96, 84, 74), (64, 92, 84), (206, 176, 84)
_TOP, _WIDTH, _BORDER, _PLANK = 0.38, 0.3, 0.03, 0.05
"""Where the door begins and how large it is, as shares of the picture."""


def door(size, seed):
    """Make the exemplar; returns (size, size, 3) uint8."""
    rng = np.random.default_rng(seed)
    colours = wall(rng, size, _SANDSTONE, 12) + 20 * smooth_noise(rng, size, 1)
    y, x = np.mgrid[:size, :size] / size
    aside = np.abs(x - 0.5)
    frame = (aside < _WIDTH / 2 + _BORDER) & (y > _TOP - _BORDER)
    leaf = (aside < _WIDTH / 2) & (y > _TOP)
    grain = 26 * smooth_noise(rng, size, (8, 0.8))
    colours = np.where(frame[..., None], np.array(_FRAME) + grain / 2, colours)
    planks = np.array(_WOOD) + grain - 26 * (((x - 0.5) / _PLANK) % 1 < 0.12)[..., None]
    colours = np.where(leaf[..., None], planks, colours)
    handle = np.hypot(x - 0.5 - 0.36 * _WIDTH, y - 0.7) < 0.016
    colours[handle] = _HANDLE
    return picture(colours)
