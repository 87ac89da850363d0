"""Small exemplars, and parameters that suit them."""

import numpy as np

from stylit_ref import TextureParams


def spots(seed=0, side=48, channels=3):
    """Soft spots, no two alike: (side, side, channels) uint8."""
    random = np.random.default_rng(seed)
    y, x = np.mgrid[:side, :side]
    image = np.full((side, side, channels), 90.0)
    for _ in range(side * side // 60):
        centre, colour = random.uniform(0, side, 2), random.uniform(-90, 90, channels)
        away = np.hypot(y - centre[0], x - centre[1])
        image += colour * np.exp(-((away / 3) ** 2))[:, :, None]
    return np.clip(image, 0, 255).astype(np.uint8)


def quick(**changes):
    """Small patches, a few iterations."""
    return TextureParams(**{"radius": 8, "iterations": 10, "candidates": 16, **changes})


def identity(height, width):
    """Coordinates with which exemplar 0 shows itself."""
    y, x = np.mgrid[:height, :width].astype(np.int32) * 4
    return np.stack([np.zeros_like(y), y, x], axis=-1)
