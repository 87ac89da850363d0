r"""φ compared without evaluating most of it: three exact savings.

:mod:`improve_assignment` evaluates λρ and δ of both patches in full. Here a candidate
is dropped as soon as a part of its φ proves that the whole cannot be lower than the
best φ so far; all numbers are exact integers, so the decisions are the same
(``tests/passes/test_proposals.py`` holds the two together).

1. W(Q), Ω summed over the patch, is kept for every patch (one read in place of 25).
2. λρ(Q) alone is compared before any pixel is read.
3. δ is bounded from below by patch sums. By Cauchy-Schwarz, per channel,

   .. math:: \sum (f - g)^2 \ge \frac{(\sum f - \sum g)^2}{n}

   over the n pixels of the patch (successive elimination, Li and Salari 1995).
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numba import njit

from stylit_ref.formulae.row_differences import make_weighted_ssd

# Differences of sums must fit the int16 lanes: 11 * 11 * 255 does. A wider patch is
# bounded by its central 11 x 11 pixels, which is still a lower bound of the whole.
WIDEST_SUM = 11


class Textures(NamedTuple):
    """Ā and B̄ of one pyramid level with their patch sums, as the metric reads them.

    Attributes
    ----------
    source : (H_A, W_A, C) uint8
    target : (H_B + 2 radius, W_B + 2 radius, C) uint8
        Edge pixels repeated ``radius`` times.
    source_sums : (H_A, W_A, C) int16
        Per channel, the sum over the patch centred at each pixel (zero at centres
        whose patch leaves the source).
    target_sums : (H_B, W_B, C) int16
    weights : (C,) int64
        Fixed-point weight of each channel.
    pair_weights : (C / 2,) uint32
        The same, one for two neighbouring channels.
    """

    source: np.ndarray
    target: np.ndarray
    source_sums: np.ndarray
    target_sums: np.ndarray
    weights: np.ndarray
    pair_weights: np.ndarray


def sum_width(patch_width):
    """Width of the block whose sums bound δ."""
    return min(patch_width, WIDEST_SUM)


@lru_cache
def make_bounded_metric(patch_width, channels):
    """Compile the metric for a patch width and a number of packed channels.

    Returns
    -------
    assignment_delta : callable
        ``(textures, y, x, source_y, source_x) -> int64``, equal to
        :func:`patch_similarity.delta`.
    improve_proposal : callable
        ``(textures, omega_sums, occurrence_weight, y, x, candidate_y, candidate_x,
        best_y, best_x, best_delta, best_phi) -> (y, x, delta, phi)``: the candidate
        if its φ is strictly below ``best_phi``, otherwise the best so far.
    """
    radius = patch_width // 2
    bound_pixels = sum_width(patch_width) ** 2
    patch_ssd = make_weighted_ssd(patch_width, patch_width, channels, element_bits=8)
    sums_ssd = make_weighted_ssd(1, 1, channels, element_bits=16)

    @njit(forceinline=True)
    def assignment_delta(textures, y, x, source_y, source_x):
        source_stride = np.int64(textures.source.shape[1]) * channels
        target_stride = np.int64(textures.target.shape[1]) * channels
        return patch_ssd(
            textures.target,
            y * target_stride + x * channels,
            target_stride,
            textures.source,
            (source_y - radius) * source_stride + (source_x - radius) * channels,
            source_stride,
            textures.pair_weights,
        )

    @njit(forceinline=True)
    def delta_bound(textures, y, x, source_y, source_x):
        """``bound_pixels`` times a lower bound of δ."""
        target_offset = (y * np.int64(textures.target_sums.shape[1]) + x) * channels
        source_offset = (source_y * np.int64(textures.source_sums.shape[1]) + source_x) * channels
        return sums_ssd(
            textures.target_sums,
            target_offset,
            np.int64(0),
            textures.source_sums,
            source_offset,
            np.int64(0),
            textures.pair_weights,
        )

    @njit(forceinline=True)
    def improve_proposal(
        textures,
        omega_sums,
        occurrence_weight,
        y,
        x,
        candidate_y,
        candidate_x,
        best_y,
        best_x,
        best_delta,
        best_phi,
    ):
        best = best_y, best_x, best_delta, best_phi
        if candidate_y == best_y and candidate_x == best_x:
            return best
        penalty = occurrence_weight * omega_sums[candidate_y, candidate_x]
        room = best_phi - penalty
        if room <= 0:
            return best
        if delta_bound(textures, y, x, candidate_y, candidate_x) >= room * bound_pixels:
            return best
        delta = assignment_delta(textures, y, x, candidate_y, candidate_x)
        if delta >= room:
            return best
        return candidate_y, candidate_x, delta, penalty + delta

    return assignment_delta, improve_proposal
