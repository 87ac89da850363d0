"""The metric φ = λρ + δ and the choice between two assignments (thesis 2.2, 3.2).

The choice comes in three forms, each for the CPU and for a GPU:

ImproveAssignment of 3.2
    Takes the better of two assignments and updates Ω at once: :func:`improve_assignment` is its
    simplest form, which evaluates every term in full.
a proposal
    Takes the better of two assignments and leaves Ω as it is: :func:`make_improve_proposal`.
a commit
    Compares a proposal once more, with the current W, and takes it if it is still better:
    :func:`take_proposal`.

An assignment changes only where φ becomes strictly lower.
"""

from collections.abc import Callable

import numpy as np
from numba import njit
from numpy.typing import NDArray

from stylit_ref.formulae.patch_penalization import (
    penalization,
    penalization_by_omega,
    update_patch_omega,
)
from stylit_ref.formulae.patch_similarity import delta
from stylit_ref.machine.inlined import Compiler


@njit
def phi(
    source: NDArray[np.uint8],
    target: NDArray[np.uint8],
    weights: NDArray[np.int64],
    omega: NDArray[np.int32],
    occurrence_weight: int,
    patch_width: int,
    y: int,
    x: int,
    source_y: int,
    source_x: int,
) -> int:
    """φ(P, Q) = λρ(Q) + δ(P, Q), thesis 2.2, as an exact int64 in fixed point."""
    return penalization_by_omega(omega, occurrence_weight, patch_width, source_y, source_x) + delta(
        source, target, weights, patch_width, y, x, source_y, source_x
    )


def make_improve_assignment(
    compiled: Compiler, phi: Callable[..., int], update: Callable[..., None]
) -> Callable[..., tuple[int, int]]:
    """Compile ImproveAssignment (3.2) for a metric and an occurrence map.

    Parameters
    ----------
    compiled : callable
        Decorator: :func:`numba.njit`, or one that compiles a function for a GPU.
    phi : callable
        ``(metric, occurrences, occurrence_weight, patch_width, y, x, source_y, source_x)
        -> int64``.
    update : callable
        ``(occurrences, patch_width, source_y, source_x, change)``: updates the map.

    Returns
    -------
    callable
        ``(metric, occurrences, occurrence_weight, patch_width, y, x, candidate_y, candidate_x,
        current_y, current_x) -> (y, x)``: the candidate if its φ is strictly lower, otherwise
        the current assignment. ``metric`` is passed on to ``phi``; ``occurrences`` is Ω, or a map
        made from it.
    """

    @compiled
    def improve_assignment(
        metric,
        occurrences,
        occurrence_weight,
        patch_width,
        y,
        x,
        candidate_y,
        candidate_x,
        current_y,
        current_x,
    ):
        phi_candidate = phi(
            metric, occurrences, occurrence_weight, patch_width, y, x, candidate_y, candidate_x
        )
        phi_current = phi(
            metric, occurrences, occurrence_weight, patch_width, y, x, current_y, current_x
        )
        if phi_candidate < phi_current:
            update(occurrences, patch_width, candidate_y, candidate_x, 1)
            update(occurrences, patch_width, current_y, current_x, -1)
            return candidate_y, candidate_x
        return current_y, current_x

    return improve_assignment


@njit
def _phi_of_textures(textures, omega, occurrence_weight, patch_width, y, x, source_y, source_x):
    source, target, weights = textures
    return phi(
        source, target, weights, omega, occurrence_weight, patch_width, y, x, source_y, source_x
    )


improve_assignment: Callable[..., tuple[int, int]] = make_improve_assignment(
    njit, _phi_of_textures, update_patch_omega
)
"""ImproveAssignment with Ω; its ``metric`` is the tuple ``(source, target, weights)``."""


def make_improve_proposal(
    compiled: Compiler, delta_below: Callable[..., int]
) -> Callable[..., tuple[int, int, int, int]]:
    """Compile ImproveAssignment without its changes to Ω.

    Parameters
    ----------
    compiled : callable
        As for :func:`make_improve_assignment`.
    delta_below : callable
        ``(metric, y, x, source_y, source_x, limit) -> int64``: δ if it is below ``limit``,
        otherwise any number of at least ``limit``.

    Returns
    -------
    callable
        ``(metric, omega_sums, occurrence_weight, y, x, candidate_y, candidate_x, best_y, best_x,
        best_delta, best_phi) -> (y, x, delta, phi)``: the candidate if its φ is strictly below
        ``best_phi``, otherwise the best so far. λρ alone is compared before any pixel is read.
    """

    @compiled
    def improve_proposal(
        metric,
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
        penalty = penalization(omega_sums, occurrence_weight, candidate_y, candidate_x)
        if (candidate_y == best_y and candidate_x == best_x) or penalty >= best_phi:
            return best
        delta = delta_below(metric, y, x, candidate_y, candidate_x, best_phi - penalty)
        if penalty + delta >= best_phi:
            return best
        return candidate_y, candidate_x, delta, penalty + delta

    return improve_proposal


@njit(inline="always")
def take_proposal(
    nnf: NDArray[np.int32],
    delta: NDArray[np.int64],
    proposed_nnf: NDArray[np.int32],
    proposed_delta: NDArray[np.int64],
    omega_sums: NDArray[np.int32],
    occurrence_weight: int,
    y: int,
    x: int,
) -> bool:
    """Assign the proposal of a pixel if that lowers φ with the current W.

    The old assignment replaces the proposal in either case: if NNF and NNF' differ afterwards, the
    pixel has moved.

    Parameters
    ----------
    nnf, delta : (H_B, W_B, 2) int32 and (H_B, W_B) int64
    proposed_nnf, proposed_delta : arrays like ``nnf`` and ``delta``
    omega_sums : (H_A, W_A) int32
    occurrence_weight, y, x : int

    Returns
    -------
    bool
        Whether the pixel moved.
    """
    old_y, old_x = nnf[y, x, 0], nnf[y, x, 1]
    new_y, new_x = proposed_nnf[y, x, 0], proposed_nnf[y, x, 1]
    if old_y == new_y and old_x == new_x:
        return False
    old_phi = delta[y, x] + penalization(omega_sums, occurrence_weight, old_y, old_x)
    new_phi = proposed_delta[y, x] + penalization(omega_sums, occurrence_weight, new_y, new_x)
    proposed_nnf[y, x, 0], proposed_nnf[y, x, 1] = old_y, old_x
    if new_phi >= old_phi:
        return False
    nnf[y, x, 0], nnf[y, x, 1] = new_y, new_x
    delta[y, x] = proposed_delta[y, x]
    return True
