"""The choice between two assignments while Ω stays as it is, in its plainest form.

What one thread of a CUDA kernel does with a candidate, one formula after the other.
:mod:`bounded_metric` makes the same decisions with vectors and a bound.
"""

from functools import lru_cache

import numpy as np
from numba import njit

from stylit_ref.formulae.guide_map import delta_by_means
from stylit_ref.formulae.patch_similarity import delta


@njit
def penalization(omega_sums, occurrence_weight, source_y, source_x):
    """λρ(Q) as an exact int64 in fixed point, from W (thesis 2.1)."""
    return occurrence_weight * np.int64(omega_sums[source_y, source_x])


@lru_cache
def make_assignment_delta(mean_channels):
    """Compile δ for the plain metric (0), or for a guide map of as many guide channels.

    Returns
    -------
    callable
        ``(source, patches, weights, guide_map, target_sums, source_sums, patch_width, y, x,
        patch_y, patch_x, source_y, source_x) -> int64``. ``patches`` is B̄ or a part of it, and
        ``(patch_y, patch_x)`` the place there of target patch ``(y, x)``.
    """

    @njit
    def assignment_delta(
        source, patches, weights, guide_map, target_sums, source_sums, patch_width,
        y, x, patch_y, patch_x, source_y, source_x,
    ):  # fmt: skip
        if mean_channels and guide_map[y, x]:
            return delta_by_means(
                source, patches, weights, target_sums[y, x], source_sums[source_y, source_x],
                patch_width, patch_y, patch_x, source_y, source_x,
            )  # fmt: skip
        return delta(source, patches, weights, patch_width, patch_y, patch_x, source_y, source_x)

    return assignment_delta


@lru_cache
def make_improve_proposal(mean_channels):
    """Compile ImproveAssignment (3.2) without its changes to Ω.

    Returns
    -------
    callable
        ``(source, patches, weights, guide_map, target_sums, source_sums, omega_sums,
        occurrence_weight, patch_width, y, x, patch_y, patch_x, candidate_y, candidate_x, best_y,
        best_x, best_delta, best_phi) -> (y, x, delta, phi)``: the candidate if its φ is
        strictly below ``best_phi``, otherwise the best so far. λρ alone is compared before any
        pixel is read.
    """
    assignment_delta = make_assignment_delta(mean_channels)

    @njit
    def improve_proposal(
        source, patches, weights, guide_map, target_sums, source_sums, omega_sums,
        occurrence_weight, patch_width, y, x, patch_y, patch_x,
        candidate_y, candidate_x, best_y, best_x, best_delta, best_phi,
    ):  # fmt: skip
        best = np.int64(best_y), np.int64(best_x), np.int64(best_delta), np.int64(best_phi)
        if candidate_y == best_y and candidate_x == best_x:
            return best
        penalty = penalization(omega_sums, occurrence_weight, candidate_y, candidate_x)
        if penalty >= best_phi:
            return best
        new_delta = assignment_delta(
            source, patches, weights, guide_map, target_sums, source_sums, patch_width,
            y, x, patch_y, patch_x, candidate_y, candidate_x,
        )  # fmt: skip
        if penalty + new_delta >= best_phi:
            return best
        return np.int64(candidate_y), np.int64(candidate_x), new_delta, penalty + new_delta

    return improve_proposal
