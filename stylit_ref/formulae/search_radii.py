"""The radii of random search, and the random numbers of each (thesis 3.3).

The radius doubles from 1 up to half the larger side of the target. A draw gives four random words
and a candidate takes two, so two radii share a draw.
"""

import numpy as np
from numba import njit

from stylit_ref.randomness.philox import FourWords


@njit(inline="always")
def search_radius(k: int) -> int:
    """Radius of the square of candidate ``k``, counted from 0."""
    return 1 << k


def number_of_radii(side: int) -> int:
    """Number of radii up to half of ``side``."""
    return (int(side) // 2).bit_length()


@njit(inline="always")
def search_draw(k: int) -> int:
    """Number of the draw that gives candidate ``k`` its random words."""
    return k // 2


@njit(inline="always")
def search_words(draw: FourWords, k: int) -> tuple[np.uint32, np.uint32]:
    """Words for y and x of candidate ``k``: the first two of its draw, or the last two.

    ``draw`` are the words of :func:`stylit_ref.randomness.random_stream.random_words` for the draw
    of number :func:`search_draw`.
    """
    return (draw[0], draw[1]) if k % 2 == 0 else (draw[2], draw[3])
