"""A wall of bricks in running bond, each burnt a little differently."""

import numpy as np

from data_gen.textures.noise import picture, smooth_noise

BRICK = 32, 64
"""Height and width of a brick with its joint, in pixels."""

_JOINT = 2
_MORTAR, _CLAY = (190, 185, 175), (150, 70, 50)


def bricks(size, seed):
    """Make the exemplar; returns (size, size, 3) uint8."""
    rng = np.random.default_rng(seed)
    return picture(wall(rng, size, _CLAY, 18) + 25 * smooth_noise(rng, size, 1))


def wall(rng, size, colour, spread):
    """The bricks without grain.

    Parameters
    ----------
    rng : numpy.random.Generator
    size : int
    colour : tuple of 3 int
    spread : float
        Standard deviation of a brick's lightness.

    Returns
    -------
    (size, size, 3) float64
    """
    colours = np.empty((size, size, 3))
    colours[:] = _MORTAR
    height, width = BRICK
    for row in range(-(-size // height)):
        for column in range(-(-size // width) + 1):
            tone = np.array(colour) + rng.normal(0, spread) + rng.normal(0, spread / 3, 3)
            top, left = row * height, column * width - row % 2 * width // 2
            colours[
                top + _JOINT : top + height - _JOINT,
                max(left + _JOINT, 0) : max(left + width - _JOINT, 0),
            ] = tone
    return colours
