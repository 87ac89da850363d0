"""Comparing vectors in whole numbers, so that every machine decides alike."""

import math

from numba import njit

ONE = 256
"""A pixel: vectors are compared in units of 1/256."""

FARTHEST = 1 << 18
"""No component counts as longer, in pixels; a hundred times the squares of two then fit 64 bits."""

# Sundaram, Brox and Keutzer 2010, section 4: forward and backward motion may differ by a hundredth
# of their squared lengths, and by half a squared pixel.
RELATIVE = 100
ABSOLUTE = ONE * ONE // 2


@njit
def fixed(value: float) -> int:
    """A component in units of 1/256 pixel, rounded half up; a value that is no number is 0."""
    if not abs(value) <= FARTHEST:
        return 0 if math.isnan(value) else (FARTHEST * ONE if value > 0 else -FARTHEST * ONE)
    return int(math.floor(value * ONE + 0.5))  # noqa: RUF046, a float on a GPU


@njit
def is_consistent(x: int, y: int, back_x: int, back_y: int) -> bool:
    """Whether a vector and the one at its end, which leads back, cancel (Sundaram et al. 2010).

    |f + b|² <= 0.01 (|f|² + |b|²) + 0.5

    Parameters
    ----------
    x, y : int
        The vector, in units of 1/256 pixel.
    back_x, back_y : int
        The vector of the other frame's pixel that it leads to.
    """
    away = (x + back_x) * (x + back_x) + (y + back_y) * (y + back_y)
    lengths = x * x + y * y + back_x * back_x + back_y * back_y
    return RELATIVE * (away - ABSOLUTE) <= lengths


@njit
def differ(x: int, y: int, other_x: int, other_y: int) -> bool:
    """Whether two vectors, in units of 1/256, differ by more than a pixel along an axis."""
    return abs(x - other_x) > ONE or abs(y - other_y) > ONE
