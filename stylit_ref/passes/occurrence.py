"""The occurrence map Ω of a whole NNF, and its sums over patches (thesis 2.1, 3.2).

Ω counts, at each source pixel, the assigned patches that cover it: the box sum of
n, the number of target patches assigned to each centre. W, Ω summed over a patch, is
the box sum of Ω. Three maps of integers, so the order of additions does not matter.
"""

import numpy as np
from numba import njit, prange


@njit
def count_assignments(nnf, counts):
    """n: how many target patches are assigned to each source centre.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
        Negative where a mask leaves the pixel alone.
    counts : (H_A, W_A) int32
        Zeros; receives n.
    """
    for y in range(nnf.shape[0]):
        for x in range(nnf.shape[1]):
            if nnf[y, x, 0] >= 0:
                counts[nnf[y, x, 0], nnf[y, x, 1]] += 1


@njit(parallel=True)
def box_sum(values, sums, patch_width):
    """Sum over the patch around each pixel; outside the image counts as zero.

    Parameters
    ----------
    values, sums : (H, W) int32
        ``sums`` is overwritten.
    patch_width : int
    """
    height, width = values.shape
    radius = patch_width // 2
    for y in prange(height):
        columns = np.zeros(width + 2 * radius, np.int32)
        for near_y in range(max(y - radius, 0), min(y + radius + 1, height)):
            for x in range(width):
                columns[radius + x] += values[near_y, x]
        sums[y, :] = 0
        for dx in range(patch_width):
            for x in range(width):
                sums[y, x] += columns[dx + x]


def occurrence_map(nnf, omega, omega_sums, patch_width):
    """Ω and W of an NNF (InitOccurrenceMap, thesis 2.3).

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
        Negative where a mask leaves the pixel alone.
    omega, omega_sums : (H_A, W_A) int32
        Overwritten.
    patch_width : int
    """
    counts = np.zeros_like(omega)
    count_assignments(nnf, counts)
    box_sum(counts, omega, patch_width)
    box_sum(omega, omega_sums, patch_width)
