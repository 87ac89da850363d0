"""The metric φ = λρ + δ and the choice between two assignments (thesis 2.2, 3.2).

The plainest form, every term in full. :mod:`bounded_metric` makes the same
decisions faster.
"""

from numba import njit

from stylit_ref.formulae.patch_penalization import patch_omega, update_patch_omega
from stylit_ref.formulae.patch_similarity import delta


@njit
def phi(source, target, weights, omega, occurrence_weight, patch_width, y, x, source_y, source_x):
    """φ(P, Q) = λρ(Q) + δ(P, Q), thesis 2.2, as an exact int64 in fixed point."""
    return occurrence_weight * patch_omega(omega, patch_width, source_y, source_x) + delta(
        source, target, weights, patch_width, y, x, source_y, source_x
    )


@njit
def improve_assignment(
    source,
    target,
    weights,
    omega,
    occurrence_weight,
    patch_width,
    y,
    x,
    candidate_y,
    candidate_x,
    current_y,
    current_x,
):
    """Keep the closer of two assignments and bring Ω up to date (ImproveAssignment, 3.2).

    Returns
    -------
    tuple of 2 int
        The candidate where its φ is strictly lower, otherwise the current assignment.
    """
    phi_candidate = phi(
        source, target, weights, omega, occurrence_weight, patch_width,
        y, x, candidate_y, candidate_x,
    )  # fmt: skip
    phi_current = phi(
        source, target, weights, omega, occurrence_weight, patch_width,
        y, x, current_y, current_x,
    )  # fmt: skip
    if phi_candidate < phi_current:
        update_patch_omega(omega, patch_width, candidate_y, candidate_x, 1)
        update_patch_omega(omega, patch_width, current_y, current_x, -1)
        return candidate_y, candidate_x
    return current_y, current_x
