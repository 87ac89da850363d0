"""Small exemplars that tests make themselves."""

import numpy as np


def blobs(height=40, width=44, channels=3, seed=1):
    """Soft spots of several colours on a ground with noise."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[:height, :width]
    image = rng.normal(110, 8, (height, width, channels))
    for _ in range(height * width // 120):
        centre, radius = rng.uniform(0, (height, width)), rng.uniform(2, 5)
        inside = np.hypot(y - centre[0], x - centre[1]) < radius
        image[inside] = rng.uniform(0, 255, channels)
    return image.clip(0, 255).astype(np.uint8)


def stripes(height=40, width=44):
    """Slanted lines in one channel."""
    y, x = np.mgrid[:height, :width]
    return ((x + y // 2) % 8 * 30 + 10).astype(np.uint8)
