"""Commit: turn proposals into assignments and update Ω (the canonical schedule).

The thesis' kernels update Ω with atomics as they run, so the outcome depends on which thread comes
first. With Ω frozen instead, too many patches rush to the same unused source pixels at once. Here
the search only proposes. Then the target pixels commit in the classes of an interleaved lattice,
one class after another; each pixel compares its proposal once more, with the current Ω.
"""

import numpy as np
from numba import get_num_threads, njit, prange, set_num_threads
from numpy.typing import NDArray

from stylit_ref.formulae.improve_assignment import take_proposal
from stylit_ref.formulae.patch_penalization import update_omega_sums
from stylit_ref.machine.kernel import kernel
from stylit_ref.metric.proposal import Commitment
from stylit_ref.randomness.commit_classes import CLASS_STRIDE, commit_order
from stylit_ref.randomness.philox import FourWords

# Threads wait for each other 33 times in a commit. On fewer pixels than this, waiting costs more
# than threads save, and far more if other programs delay one of them.
FEWEST_PIXELS_FOR_THREADS = 30_000


@njit(forceinline=True)
def _decide(nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight, y, columns):
    """Move or leave the pixels of a row that have a proposal.

    Moves the ``columns`` of the pixels that moved to the front; returns their number.
    """
    moved = 0
    for x in columns:
        if take_proposal(
            nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight, y, x
        ):
            columns[moved] = x
            moved += 1
    return moved


@kernel()
def _commit(commitment, columns, counts, order, bands):
    nnf, delta, proposed_nnf, proposed_delta = commitment[:4]
    omega_sums, occurrence_weight, patch_width, stream, _ = commitment[4:]
    height, width = delta.shape
    for y in prange(height):
        for x in range(width):
            if nnf[y, x, 0] != proposed_nnf[y, x, 0] or nnf[y, x, 1] != proposed_nnf[y, x, 1]:
                place = x % CLASS_STRIDE
                columns[y, place, counts[y, place]] = x
                counts[y, place] += 1

    commit_order(stream, order)
    for n in range(order.shape[0]):
        first_y, first_x = order[n, 0], order[n, 1]
        for row in prange(-(-(height - first_y) // CLASS_STRIDE)):
            y = first_y + CLASS_STRIDE * row
            counts[y, first_x] = _decide(
                nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight,
                y, columns[y, first_x, : counts[y, first_x]],
            )  # fmt: skip
        if not occurrence_weight:
            continue
        # Each thread updates a band of W's rows, for all moves that affect it.
        for band in prange(bands):
            first_row = omega_sums.shape[0] * band // bands
            rows = omega_sums[first_row : omega_sums.shape[0] * (band + 1) // bands]
            for y in range(first_y, height, CLASS_STRIDE):
                for x in columns[y, first_x, : counts[y, first_x]]:
                    update_omega_sums(rows, patch_width, nnf[y, x, 0] - first_row, nnf[y, x, 1], 1)
                    update_omega_sums(
                        rows, patch_width,
                        proposed_nnf[y, x, 0] - first_row, proposed_nnf[y, x, 1], -1,
                    )  # fmt: skip


def commit(
    nnf: NDArray[np.int32],
    delta: NDArray[np.int64],
    proposed_nnf: NDArray[np.int32],
    proposed_delta: NDArray[np.int64],
    omega_sums: NDArray[np.int32],
    occurrence_weight: int,
    patch_width: int,
    stream: FourWords,
    moves: NDArray[np.int64],
) -> None:
    """Accept the proposals that lower φ, one class of target pixels after another.

    All decisions of a class read W as it was when the class began; then W is updated.

    Parameters
    ----------
    nnf, delta : (H_B, W_B, 2) int32 and (H_B, W_B) int64
        Assignments and their δ, updated in place.
    proposed_nnf, proposed_delta : like ``nnf`` and ``delta``
        Afterwards NNF' holds the previous assignments; the δ of proposals is undefined.
    omega_sums : (H_A, W_A) int32
        W, updated after each class. If ``occurrence_weight`` is 0, nothing reads W and it
        stays as it is.
    occurrence_weight, patch_width : int
    stream : tuple of 4 uint32
        Decides the order of the classes
        (:func:`stylit_ref.randomness.commit_classes.commit_order`).
    moves : (1,) int64
        The number of pixels that moved is added to it.
    """
    commitment = Commitment(
        nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight, patch_width,
        stream, moves,
    )  # fmt: skip
    height, width = delta.shape
    # Columns of the pixels that have a proposal, by row and class; later of those that moved.
    columns = np.empty((height, CLASS_STRIDE, -(-width // CLASS_STRIDE)), np.int32)
    counts = np.zeros((height, CLASS_STRIDE), np.int32)
    order = np.empty((CLASS_STRIDE**2, 2), np.int32)
    available = get_num_threads()
    threads = available if delta.size >= FEWEST_PIXELS_FOR_THREADS else 1
    set_num_threads(threads)
    try:
        _commit(commitment, columns, counts, order, threads)
    finally:
        set_num_threads(available)
    moves[0] += counts.sum()
