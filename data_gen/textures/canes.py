"""Upright canes of different widths, with knots."""

import numpy as np

from data_gen.textures.noise import picture, smooth_noise


def canes(size, seed):
    """Make the exemplar; returns (size, size, 3) uint8."""
    rng = np.random.default_rng(seed)
    colours, left = np.zeros((size, size, 3)), 0
    while left < size:
        width = int(rng.integers(12, 24))
        across = np.arange(left, min(size, left + width))
        roundness = np.sqrt(np.sin(np.pi * (across - left + 0.5) / width))
        tone = np.array((190, 160, 90)) + rng.normal(0, 20)
        colours[:, across] = roundness[:, None] * tone
        knot = int(rng.integers(0, 80))
        while knot < size:
            colours[max(0, knot - 2) : knot + 3, across] *= 0.6
            knot += int(rng.integers(60, 100))
        left += width
    return picture(colours + 50 * smooth_noise(rng, size, (6, 0.7)), 0.6)
