"""Means of 8-bit values, rounded half up: of votes, and of the four pixels that become one."""

import numpy as np
from numba import njit
from numpy.typing import NDArray


@njit
def rounded_mean(total: int, count: int) -> int:
    """``total / count`` rounded half up; 0 if ``count`` is 0."""
    return (2 * total + count) // (2 * count) if count else 0


@njit
def block_mean(image: NDArray[np.uint8], y: int, x: int, channel: int) -> int:
    """A pixel of the next coarser level: the mean of 2 x 2, rounded half up (thesis 3.4).

    The thesis gives no source code; it samples with bilinear interpolation, which at a factor of
    two is this mean.
    """
    total = (
        np.int32(image[2 * y, 2 * x, channel])
        + np.int32(image[2 * y, 2 * x + 1, channel])
        + np.int32(image[2 * y + 1, 2 * x, channel])
        + np.int32(image[2 * y + 1, 2 * x + 1, channel])
    )
    return (total + 2) // 4
