"""Commit: proposals become assignments while Ω follows (the canonical schedule).

The thesis' kernels update Ω with atomics as they run, so the outcome depends on which
thread comes first. With Ω frozen instead, too many patches rush to the same unused
source pixels at once. Here the search only proposes; the proposals are then taken up
class by class of an interleaved lattice, each compared once more with Ω as it stands.
"""

import numpy as np
from numba import njit

from stylit_ref.formulae.patch_penalization import update_omega_sums


@njit
def _decide(
    nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight,
    first_y, first_x, stride, moved,
):  # fmt: skip
    """Exchange assignment and proposal of a class where φ falls; list the pixels."""
    count = 0
    for y in range(first_y, nnf.shape[0], stride):
        for x in range(first_x, nnf.shape[1], stride):
            old_y, old_x = nnf[y, x, 0], nnf[y, x, 1]
            new_y, new_x = proposed_nnf[y, x, 0], proposed_nnf[y, x, 1]
            if new_y == old_y and new_x == old_x:
                continue
            old_phi = delta[y, x] + occurrence_weight * omega_sums[old_y, old_x]
            new_phi = proposed_delta[y, x] + occurrence_weight * omega_sums[new_y, new_x]
            if new_phi < old_phi:
                nnf[y, x, 0], nnf[y, x, 1] = new_y, new_x
                proposed_nnf[y, x, 0], proposed_nnf[y, x, 1] = old_y, old_x
                delta[y, x] = proposed_delta[y, x]
                moved[count, 0], moved[count, 1] = y, x
                count += 1
    return count


@njit
def commit(
    nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight, patch_width,
    classes, stride,
):  # fmt: skip
    """Take up proposals where φ falls, one class of target pixels after another.

    Within a class all decisions read W as the class began; then W follows.

    Parameters
    ----------
    nnf, delta : (H_B, W_B, 2) int32 and (H_B, W_B) int64
        Assignments and their δ, updated in place.
    proposed_nnf, proposed_delta : like ``nnf`` and ``delta``
        Spent: they hold nothing of use afterwards.
    omega_sums : (H_A, W_A) int32
        W, brought up to date after each class. Left alone where ``occurrence_weight``
        is 0 and nothing reads it.
    occurrence_weight, patch_width : int
    classes : sequence of (int, int)
        First row and column of each class, in order.
    stride : int
        Pixels between members of a class on each axis.

    Returns
    -------
    int
        Number of pixels that moved.
    """
    moved = np.empty((-(-nnf.shape[0] // stride) * -(-nnf.shape[1] // stride), 2), np.int32)
    total = 0
    for first_y, first_x in classes:
        count = _decide(
            nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight,
            first_y, first_x, stride, moved,
        )  # fmt: skip
        if occurrence_weight:
            for k in range(count):
                y, x = moved[k, 0], moved[k, 1]
                update_omega_sums(omega_sums, patch_width, nnf[y, x, 0], nnf[y, x, 1], 1)
                update_omega_sums(
                    omega_sums, patch_width, proposed_nnf[y, x, 0], proposed_nnf[y, x, 1], -1
                )
        total += count
    return total
