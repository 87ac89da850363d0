"""Means of bytes, rounded half up: of four patches (equation 17), of a box or a texel (19, 20)."""

import numpy as np
from numba import njit


@njit
def mean_of_four(a: int, b: int, c: int, d: int) -> np.uint8:
    """Of a pixel's patches; where there are one or two, each counts four times or twice."""
    total = np.uint32(a) + np.uint32(b) + np.uint32(c) + np.uint32(d)
    return np.uint8((total + np.uint32(2)) >> np.uint32(2))


@njit
def mean_of(total: int, count: int) -> np.uint8:
    """Of ``count`` bytes that sum up to ``total``."""
    return np.uint8((np.uint32(total) + np.uint32(count) // np.uint32(2)) // np.uint32(count))


@njit
def bilinear(near: int, beside: int, below: int, diagonal: int) -> np.uint8:
    """A pixel of B' from the next coarser level (5.2.4), centres aligned: weights 9, 3, 3, 1."""
    total = np.uint32(9) * near + np.uint32(3) * (np.uint32(beside) + below) + np.uint32(diagonal)
    return np.uint8((total + np.uint32(8)) >> np.uint32(4))


def box_radius(scale: int) -> int:
    """Of the box whose mean is an entry of the scale space: 1x1, 3x3, 9x9, 27x27."""
    return (3**scale - 1) // 2
