"""Pale marble with dark veins."""

import numpy as np

from data_gen.textures.noise import clouds, picture, smooth_noise

_STONE, _SHADE, _VEIN = (232, 228, 222), (196, 192, 192), (92, 94, 104)


def marble(size, seed):
    """Make the exemplar; returns (size, size, 3) uint8."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[:size, :size]
    shade = (0.5 + 0.3 * clouds(rng, size, 32))[..., None].clip(0, 1)
    colours = (1 - shade) * np.array(_STONE) + shade * np.array(_SHADE)
    for spacing, width, strength in ((70, 0.05, 1.0), (34, 0.035, 0.55)):
        along = (x + 0.6 * y) / spacing + 0.55 * clouds(rng, size, 24)
        vein = strength * np.exp(-np.abs(np.sin(np.pi * along)) / width)[..., None]
        colours = (1 - vein) * colours + vein * np.array(_VEIN)
    return picture(colours + 8 * smooth_noise(rng, size, 0.8))
