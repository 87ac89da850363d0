"""The occurrence map Ω of a whole NNF, and its sums over patches (thesis 2.1, 3.2).

Let n be the number of target patches assigned to each source centre. Ω counts, at each source
pixel, the assigned patches that cover it, so it is the box sum of n. W, Ω summed over a patch, is
the box sum of Ω. All three are maps of integers, so the order of additions does not matter.
"""

import numpy as np
from numpy.typing import NDArray

_ROWS = 64
"""So many are done at a time, since what is made on the way takes several times their memory."""


def count_assignments(nnf: NDArray[np.int32], source_size: tuple[int, int]) -> NDArray[np.int32]:
    """n, the number of target patches assigned to each source centre.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
        Negative where a mask leaves the pixel alone.
    source_size : (int, int)
        Rows and columns of the source.

    Returns
    -------
    (H_A, W_A) int32
    """
    height, width = source_size
    counts = np.zeros(height * width, np.int32)
    for first in range(0, len(nnf), _ROWS):
        y, x = np.moveaxis(nnf[first : first + _ROWS], -1, 0)
        assigned = y >= 0
        places = y[assigned].astype(np.int64) * width + x[assigned]
        np.add.at(counts, places, np.int32(1))
    return counts.reshape(source_size)


def box_sum(values: NDArray[np.int32], patch_width: int) -> NDArray[np.int32]:
    """Sum over the patch around each pixel; values outside the image are zero.

    Parameters
    ----------
    values : (H, W) int32
    patch_width : int

    Returns
    -------
    (H, W) int32
    """
    radius = patch_width // 2
    height, width = values.shape
    padded, sums = np.pad(values, radius), np.empty_like(values)
    for first in range(0, height, _ROWS):
        last = min(first + _ROWS, height)
        rows = sum(padded[first + dy : last + dy] for dy in range(patch_width))
        sums[first:last] = sum(rows[:, dx : dx + width] for dx in range(patch_width))
    return sums


def occurrence_map(
    nnf: NDArray[np.int32],
    omega: NDArray[np.int32],
    omega_sums: NDArray[np.int32],
    patch_width: int,
) -> None:
    """Ω and W of an NNF (InitOccurrenceMap, thesis 2.3).

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
        Negative where a mask leaves the pixel alone.
    omega, omega_sums : (H_A, W_A) int32
        Overwritten.
    patch_width : int
    """
    omega[:] = box_sum(count_assignments(nnf, omega.shape), patch_width)
    omega_sums[:] = box_sum(omega, patch_width)
