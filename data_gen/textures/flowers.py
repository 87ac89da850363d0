"""Flowers of five petals, strewn over grass."""

import numpy as np

from data_gen.textures.noise import picture, smooth_noise

_PETALS = 5
_GRASS, _BLADES = (60, 110, 50), (0.6, 1, 0.5)
_COLOURS = (230, 220, 235), (225, 180, 60), (205, 80, 120)
_MIDDLE = 235, 200, 40
_PIXELS_A_FLOWER = 1600


def flowers(size, seed):
    """Make the exemplar; returns (size, size, 3) uint8."""
    rng = np.random.default_rng(seed)
    colours = np.array(_GRASS) + 90 * smooth_noise(rng, size, 1.5) * np.array(_BLADES)
    y, x = np.mgrid[:size, :size]
    for centre, radius in _places(rng, size):
        first = np.maximum(0, np.floor(centre - radius)).astype(int)
        last = np.ceil(centre + radius).astype(int) + 1
        around = np.s_[first[0] : last[0], first[1] : last[1]]
        down, along = y[around] - centre[0], x[around] - centre[1]
        distance = np.hypot(down, along)
        turned = _PETALS / 2 * (np.arctan2(down, along) + rng.uniform(0, 2 * np.pi))
        petals = distance < radius * (0.62 + 0.38 * np.abs(np.cos(turned)))
        shade = 1 - 0.35 * distance[petals] / radius
        colours[around][petals] = np.array(_COLOURS[rng.integers(3)]) * shade[:, None]
        colours[around][distance < radius / 4] = _MIDDLE
    return picture(colours)


def _places(rng, size):
    """Centres and radii of flowers that do not touch."""
    places = []
    for _ in range(4000):
        centre, radius = rng.uniform(0, size, 2), rng.uniform(10, 17)
        if all(np.hypot(*(centre - other)) > radius + reach + 3 for other, reach in places):
            places.append((centre, radius))
        if len(places) > size * size // _PIXELS_A_FLOWER:
            break
    return places
