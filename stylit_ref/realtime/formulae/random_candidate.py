"""A random position in the source from 32 random bits: 16 for y, 16 for x."""

import numpy as np
from numba import njit


@njit
def random_row(word: int, first: int, last: int) -> int:
    """Y in ``[first, last]``, from the high 16 bits."""
    return first + (np.int64(word >> np.uint32(16)) * (last - first + 1) >> 16)


@njit
def random_column(word: int, first: int, last: int) -> int:
    """X in ``[first, last]``, from the low 16 bits."""
    return first + (np.int64(word & np.uint32(0xFFFF)) * (last - first + 1) >> 16)
