"""The choice between two assignments while Ω stays as it is: ImproveAssignment (thesis 3.2)."""

from functools import lru_cache

import numpy as np
from numba import njit

from gpu_cuda.patch_ssd import make_patch_ssd
from stylit_ref.formulae.patch_penalization import penalization

NO_LIMIT = np.iinfo(np.int64).max


@lru_cache
def make_assignment_delta(constants):
    """Compile δ, with a guide map that of thesis 5.2.2.

    Parameters
    ----------
    constants : gpu_cuda.metric.MetricConstants

    Returns
    -------
    callable
        ``(metric, source_width, patch, y, x, source_y, source_x, limit) -> int64``: equal to
        :func:`stylit_ref.formulae.patch_similarity.delta` or
        :func:`stylit_ref.formulae.guide_map.delta_by_means`; a number of at least ``limit``
        where those are. ``metric`` is Ā, weights, G, M_B and M_A of
        :func:`gpu_cuda.metric.metric_arrays`, ``patch`` the target patch as
        :mod:`gpu_cuda.target_patches` has it.
    """
    patch_width, _, weighted_channels, mean_channels = constants
    pixel_words, radius = constants.pixel_words, constants.radius
    patch_ssd = make_patch_ssd(patch_width, weighted_channels, 0)
    style_ssd = make_patch_ssd(patch_width, weighted_channels, mean_channels)

    @njit
    def assignment_delta(metric, source_width, patch, y, x, source_y, source_x, limit):
        source, pair_weights, guide_map, target_sums, source_sums = metric
        patches, first, pixel, row = patch
        source_first = ((source_y - radius) * source_width + source_x - radius) * pixel_words
        source_row = source_width * pixel_words
        if mean_channels and guide_map[y, x]:
            guides = np.int64(0)
            for c in range(mean_channels):
                sum_p = np.int64(target_sums[y, x, c])
                difference = sum_p - np.int64(source_sums[source_y, source_x, c])
                guides += np.int64(pair_weights[c // 2]) * difference * difference
            guides //= patch_width * patch_width
            if guides >= limit:
                return guides
            return guides + style_ssd(
                patches, first, pixel, row,
                source, source_first, pixel_words, source_row, pair_weights, limit - guides,
            )  # fmt: skip
        return patch_ssd(
            patches, first, pixel, row,
            source, source_first, pixel_words, source_row, pair_weights, limit,
        )  # fmt: skip

    return assignment_delta


@lru_cache
def make_improve_proposal(constants):
    """Compile ImproveAssignment without its changes to Ω; parameters as above.

    Returns
    -------
    callable
        ``(metric, patch, omega_sums, occurrence_weight, y, x, candidate_y, candidate_x, best_y,
        best_x, best_delta, best_phi) -> (y, x, delta, phi)``: the candidate if its φ is strictly
        below ``best_phi``, otherwise the best so far. λρ alone is compared before any pixel is
        read.
    """
    assignment_delta = make_assignment_delta(constants)

    @njit
    def improve_proposal(
        metric, patch, omega_sums, occurrence_weight, y, x,
        candidate_y, candidate_x, best_y, best_x, best_delta, best_phi,
    ):  # fmt: skip
        best = np.int64(best_y), np.int64(best_x), np.int64(best_delta), np.int64(best_phi)
        if candidate_y == best_y and candidate_x == best_x:
            return best
        penalty = penalization(omega_sums, occurrence_weight, candidate_y, candidate_x)
        if penalty >= best_phi:
            return best
        delta = assignment_delta(
            metric, omega_sums.shape[1], patch, y, x, candidate_y, candidate_x, best_phi - penalty
        )
        if penalty + delta >= best_phi:
            return best
        return np.int64(candidate_y), np.int64(candidate_x), delta, penalty + delta

    return improve_proposal
