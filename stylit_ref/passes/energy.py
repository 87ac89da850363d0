"""Texture energy: the metric summed over all target patches (thesis 2.2)."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel


@kernel()
def _sum_rows(nnf, delta, omega_sums, sums):
    for y in prange(delta.shape[0]):
        for x in range(delta.shape[1]):
            if nnf[y, x, 0] >= 0:
                sums[y, 0] += delta[y, x]
                sums[y, 1] += omega_sums[nnf[y, x, 0], nnf[y, x, 1]]
                sums[y, 2] += 1


def energy(
    nnf: NDArray[np.int32], delta: NDArray[np.int64], omega_sums: NDArray[np.int32]
) -> tuple[float, float]:
    """Mean δ and mean W over the assigned target patches.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
        Negative where a mask leaves the pixel alone.
    delta : (H_B, W_B) int64
    omega_sums : (H_A, W_A) int32

    Returns
    -------
    mean_delta, mean_omega_sum : float
        In the units of the arguments: δ in fixed point.
    """
    sums = np.zeros((delta.shape[0], 3), np.int64)
    _sum_rows(nnf, delta, omega_sums, sums)
    # Python's integers: the sum over all rows may exceed 64 bits.
    total_delta, total_omega_sum, patches = sums.astype(object).sum(axis=0)
    return total_delta / patches, total_omega_sum / patches
