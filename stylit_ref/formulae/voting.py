"""Votes of patches for pixels, and which of them count (thesis 2.3; Hauptfleisch 2020, 2.4.1)."""

import numpy as np
from numba import njit
from numpy.typing import NDArray


@njit(inline="always")
def voted_pixel(
    nnf: NDArray[np.int32], y: int, x: int, near_y: int, near_x: int
) -> tuple[int, int]:
    """The source pixel that the patch around ``(near_y, near_x)`` votes for at ``(y, x)``."""
    return nnf[near_y, near_x, 0] + y - near_y, nnf[near_y, near_x, 1] + x - near_x


@njit
def distance_from_mean(value: int, total: int, votes: int) -> int:
    """Squared distance of one vote from the mean of all, in one channel, times ``votes`` squared.

    ``total`` is the sum of all ``votes``.
    """
    return (votes * value - total) ** 2


@njit
def votes_kept(votes: int, outliers: int) -> int:
    """Number of votes that count without the ``outliers`` farthest ones; one always counts."""
    return max(votes - outliers, min(votes, 1))


@njit
def discard_farthest(distances: NDArray[np.int64], votes: int, kept: int) -> None:
    """Set the distances of the farthest votes to -1, until ``kept`` are left.

    Of equally far votes the first are discarded first.

    Parameters
    ----------
    distances : (n,) int64
        The first ``votes`` of them are used; none is negative.
    votes, kept : int
    """
    for _ in range(votes - kept):
        farthest = 0
        for vote in range(1, votes):
            if distances[vote] > distances[farthest]:
                farthest = vote
        distances[farthest] = -1
