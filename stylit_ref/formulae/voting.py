"""Votes of patches for pixels, and which of them count (thesis 2.3; Hauptfleisch 2020, 2.4.1)."""

from numba import njit


@njit(inline="always")
def voted_pixel(nnf, y, x, near_y, near_x):
    """The source pixel that the patch around ``(near_y, near_x)`` votes for at ``(y, x)``."""
    return nnf[near_y, near_x, 0] + y - near_y, nnf[near_y, near_x, 1] + x - near_x


@njit
def distance_from_mean(value, total, votes):
    """Squared distance of one vote from the mean of all, in one channel, times ``votes`` squared.

    ``total`` is the sum of all ``votes``.
    """
    return (votes * value - total) ** 2


@njit
def votes_kept(votes, outliers):
    """Number of votes that count without the ``outliers`` farthest ones; one always counts."""
    return max(votes - outliers, min(votes, 1))


@njit
def discard_farthest(distances, votes, kept):
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
