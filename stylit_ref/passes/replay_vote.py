"""Voting with another style image, at its own bit depth and possibly enlarged."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.formulae.voting import (
    discard_farthest,
    distance_from_mean,
    voted_pixel,
    votes_kept,
)
from stylit_ref.machine.kernel import kernel


@kernel()
def _replay_kernel(style, means, nnf, patch_width, scale):
    height, width = nnf.shape[:2]
    radius = patch_width // 2
    for fine_y in prange(means.shape[0]):
        y, offset_y = fine_y // scale, fine_y % scale
        for fine_x in range(means.shape[1]):
            x, offset_x = fine_x // scale, fine_x % scale
            votes = 0
            for near_y in range(max(y - radius, 0), min(y + radius + 1, height)):
                for near_x in range(max(x - radius, 0), min(x + radius + 1, width)):
                    if nnf[near_y, near_x, 0] < 0:
                        continue
                    voted_y, voted_x = voted_pixel(nnf, y, x, near_y, near_x)
                    source_y, source_x = voted_y * scale + offset_y, voted_x * scale + offset_x
                    for c in range(style.shape[2]):
                        value = np.float64(style[source_y, source_x, c])
                        means[fine_y, fine_x, c] = (
                            means[fine_y, fine_x, c] + value if votes else value
                        )
                    votes += 1
            if votes:
                for c in range(style.shape[2]):
                    means[fine_y, fine_x, c] /= votes


@kernel()
def _robust_replay_kernel(
    style, means, nnf, patch_width, scale, outliers, all_values, all_distances
):
    """The mean without the votes farthest from it, as the robust vote of a run."""
    height, width = nnf.shape[:2]
    radius = patch_width // 2
    for fine_y in prange(means.shape[0]):
        values, distances = all_values[fine_y], all_distances[fine_y]
        y, offset_y = fine_y // scale, fine_y % scale
        for fine_x in range(means.shape[1]):
            x, offset_x = fine_x // scale, fine_x % scale
            votes = 0
            for near_y in range(max(y - radius, 0), min(y + radius + 1, height)):
                for near_x in range(max(x - radius, 0), min(x + radius + 1, width)):
                    if nnf[near_y, near_x, 0] < 0:
                        continue
                    voted_y, voted_x = voted_pixel(nnf, y, x, near_y, near_x)
                    source_y, source_x = voted_y * scale + offset_y, voted_x * scale + offset_x
                    for c in range(style.shape[2]):
                        values[votes, c] = style[source_y, source_x, c]
                    distances[votes] = 0
                    votes += 1
            for c in range(style.shape[2]):
                total = 0.0
                for n in range(votes):
                    total += values[n, c]
                for n in range(votes):
                    distances[n] += distance_from_mean(values[n, c], total, votes)
            kept = votes_kept(votes, outliers)
            discard_farthest(distances, votes, kept)
            for c in range(style.shape[2]):
                total = 0.0
                for n in range(votes):
                    if distances[n] >= 0:
                        total += values[n, c]
                if votes:
                    means[fine_y, fine_x, c] = total / kept


def replay_vote(
    style: NDArray[np.uint8 | np.uint16 | np.float32],
    means: NDArray[np.float64],
    nnf: NDArray[np.int32],
    patch_width: int,
    scale: int,
    outliers: int = 0,
) -> None:
    """Mean of the votes as in :func:`stylit_ref.passes.vote.vote`, at ``scale`` times the size.

    Parameters
    ----------
    style : (scale * H_A, scale * W_A, n) uint8, uint16 or float32
    means : (scale * H_B, scale * W_B, n) float64
        Overwritten at pixels that an assigned patch covers; not rounded.
    nnf : (H_B, W_B, 2) int32
        Negative where nothing is assigned.
    patch_width, scale : int
    outliers : int
        The number of votes that do not count. Distances between integers are exact: those of
        16 bits up to a patch width of 25.
    """
    if outliers:
        rows, votes = means.shape[0], patch_width**2
        values, distances = np.empty((rows, votes, style.shape[2])), np.empty((rows, votes))
        _robust_replay_kernel(style, means, nnf, patch_width, scale, outliers, values, distances)
    else:
        _replay_kernel(style, means, nnf, patch_width, scale)
