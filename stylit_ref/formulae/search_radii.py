"""Random search: which radii it takes, and which random numbers belong to each (thesis 3.3).

The squares double from radius 1 up to half the larger side of the target. A draw gives four random
words; a candidate takes two, so two radii share a draw.
"""

from numba import njit


@njit(inline="always")
def search_radius(k):
    """Radius of the square of candidate ``k``, counted from 0."""
    return 1 << k


def number_of_radii(side):
    """How many radii do not exceed half of ``side``."""
    return (int(side) // 2).bit_length()


@njit(inline="always")
def search_draw(k):
    """Number of the draw that candidate ``k`` takes its random words from."""
    return k // 2


@njit(inline="always")
def search_words(draw, k):
    """Words for y and x of candidate ``k``: the first two of its draw, or the last two.

    ``draw`` is what :func:`stylit_ref.randomness.random_stream.random_words` gives for the draw
    :func:`search_draw`.
    """
    return (draw[0], draw[1]) if k % 2 == 0 else (draw[2], draw[3])
