"""Round pebbles side by side, lit from the upper left."""

import numpy as np
from scipy.ndimage import gaussian_filter
from scipy.spatial import cKDTree

from data_gen.textures.noise import picture, smooth_noise

_SPACING = 24
_TONES = (150, 140, 128), (120, 112, 108), (176, 164, 146), (104, 92, 84), (142, 120, 100)
_GAP = 34, 30, 27
_SHORE = 3.4
"""How far a pebble stays from the lines half way to its neighbours, in pixels, about doubled."""


def pebbles(size, seed):
    """Make the exemplar; returns (size, size, 3) uint8."""
    rng = np.random.default_rng(seed)
    seeds = np.mgrid[-2 : size // _SPACING + 3, -2 : size // _SPACING + 3].reshape(2, -1).T
    seeds = (seeds + rng.uniform(0.1, 0.9, seeds.shape)) * _SPACING
    at = np.moveaxis(np.mgrid[:size, :size], 0, -1)
    distance, nearest = cKDTree(seeds).query(at, k=2)
    (near, next_near), owner = np.moveaxis(distance, -1, 0), nearest[..., 0]
    inside = gaussian_filter((next_near - near).clip(0, 12), 2.4)  # which rounds the corners
    height = np.sqrt(((inside - _SHORE) / (12 - _SHORE)).clip(0, 1))
    down, along = np.gradient(gaussian_filter(height, 1.6) * 9)
    light = 0.8 - 0.42 * (down + along)
    tones = np.array(_TONES)[rng.integers(len(_TONES), size=len(seeds))]
    tones = tones + rng.normal(0, 8, (len(seeds), 1))
    stone = tones[owner] * light[..., None].clip(0.25, 1.35)
    cover = ((inside - _SHORE) / 0.9).clip(0, 1)[..., None]
    colours = cover * stone + (1 - cover) * np.array(_GAP)
    return picture(colours + 12 * smooth_noise(rng, size, 0.8), 0.6)
