"""What every painter here uses: palettes, curves, noise and paper.

Colours are sRGB in [0, 1].
"""

import numpy as np
from skimage.filters import gaussian
from skimage.transform import resize


def palette(colours, tones):
    """Colours from dark to light at tones in [0, 1]."""
    steps = np.linspace(0, 1, len(colours))
    return np.stack([np.interp(tones, steps, np.array(colours)[:, c]) for c in range(3)], axis=-1)


def streamlines(starts, direction, length, steps, bend=0.0):
    """Curves that follow a field of directions, to both sides of their start.

    Parameters
    ----------
    starts : (N, 2) float
        (x, y) in pixels.
    direction : (H, W) float
        Angles in radians, 0 along x, a quarter turn along y.
    length : (N,) float
        Pixels.
    steps : int
        Pieces on each side.
    bend : (N,) float or float
        Radians added to the direction.

    Returns
    -------
    (N, 2 steps + 1, 2) float
    """
    sides = []
    for sign in (-1, 1):
        points = [np.asarray(starts, float)]
        for _ in range(steps):
            angle = at(direction, points[-1]) + bend
            step = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
            points.append(points[-1] + sign * step * np.reshape(length / (2 * steps), (-1, 1)))
        sides.append(points)
    return np.stack([*sides[0][:0:-1], *sides[1]], axis=1)


def at(image, points):
    """Values of an image at the pixels that points (..., 2), (x, y), lie in."""
    height, width = image.shape[:2]
    x = np.clip(np.round(points[..., 0]).astype(int), 0, width - 1)
    y = np.clip(np.round(points[..., 1]).astype(int), 0, height - 1)
    return image[y, x]


def scattered(rng, shape, spacing):
    """Points (x, y) over an image, about ``spacing`` pixels apart, in random order."""
    height, width = shape
    y, x = np.mgrid[0 : height + spacing : spacing, 0 : width + spacing : spacing]
    points = np.stack([x.ravel(), y.ravel()], axis=-1)
    points = points + rng.uniform(-0.7, 0.7, points.shape) * spacing
    return rng.permutation(points)


def noise(rng, shape, size):
    """Smooth noise of standard deviation 1 whose blobs are about ``size`` pixels."""
    small = tuple(int(np.ceil(length / max(size / 2, 1))) + 4 for length in shape)
    values = gaussian(rng.standard_normal(small), 1.0)
    values = resize(values, shape, order=3)
    return (values - values.mean()) / values.std()


def paper_grain(rng, shape):
    """Heights of paper tooth in [0, 1], evenly spread: fine and coarse noise."""
    fine = gaussian(rng.standard_normal(shape), 0.5)
    tooth = fine / fine.std() + 0.6 * noise(rng, shape, 4.0)
    return np.argsort(np.argsort(tooth.ravel())).reshape(shape) / tooth.size
