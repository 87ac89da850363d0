"""The entries whose matches still move in a warm frame."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel

ALL = np.zeros((0, 0), np.uint8)
"""What stands for a mark at every entry."""


@inlined
def any_moves(moving: NDArray[np.uint8], a: int) -> bool:
    """Whether an entry of row ``a`` moves."""
    moves = np.uint8(0)
    for b in range(np.uint64(moving.shape[1])):
        moves |= moving[np.uint64(a), b]
    return moves != 0


@inlined
def cell_moves(moving: NDArray[np.uint8], a: int, a2: int, b: int, beside: int) -> bool:
    """Whether one of the entries of rows ``a`` and ``a2``, columns ``b`` and ``beside``, moves."""
    left = moving[np.uint64(a), np.uint64(b)] | moving[np.uint64(a2), np.uint64(b)]
    right = moving[np.uint64(a), np.uint64(beside)] | moving[np.uint64(a2), np.uint64(beside)]
    return (left | right) != 0


@kernel(parallel=False, nogil=True)
def mark_moving(
    before: NDArray[np.int32], nnf: NDArray[np.int32], moving: NDArray[np.uint8]
) -> None:
    """Mark in ``moving``, (rows, columns), the entries whose match is not that of ``before``.

    Those around them are marked too, all eight. One thread is enough for so few.
    """
    rows, columns = nnf.shape
    moving[:] = 0
    for a in range(rows):
        for b in range(columns):
            if nnf[a, b] == before[a, b]:
                continue
            for i in range(max(a - 1, 0), min(a + 2, rows)):
                for j in range(max(b - 1, 0), min(b + 2, columns)):
                    moving[i, j] = 1
