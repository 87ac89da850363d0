"""The interleaved classes of target pixels, which commit one after another."""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from stylit_ref.randomness.philox import FourWords, uniform_below
from stylit_ref.randomness.random_stream import random_words

CLASS_STRIDE = 4
"""Pixels between members of a class on each axis: 16 classes."""


@njit
def commit_order(stream: FourWords, order: NDArray[np.int32]) -> None:
    """Shuffle the classes (Fisher-Yates), so that none always chooses first.

    Parameters
    ----------
    stream : tuple of 4 uint32
    order : (16, 2) int32
        Receives the first row and column of each class, in the order of commitment.
    """
    for k in range(order.shape[0]):
        order[k, 0], order[k, 1] = k // CLASS_STRIDE, k % CLASS_STRIDE
    for last in range(order.shape[0] - 1, 0, -1):
        pick = uniform_below(random_words(stream, last, 0)[0], last + 1)
        for axis in range(2):
            order[last, axis], order[pick, axis] = order[pick, axis], order[last, axis]
