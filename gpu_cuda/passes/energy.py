"""Texture energy: the metric summed over all target patches (thesis 2.2)."""

import numpy as np
from numba import cuda

from gpu_cuda.host.argument_types import DELTA, MAP, NNF, TOTALS
from gpu_cuda.host.device import launch
from gpu_cuda.host.memory import zeros

ROWS_A_THREAD = 32


@cuda.jit
def sum_columns_kernel(nnf, delta, omega_sums, sums):
    x, chunk = cuda.grid(2)
    height, width = delta.shape
    if x >= width:
        return
    total_delta = total_omega_sum = patches = np.int64(0)
    for y in range(chunk * ROWS_A_THREAD, min((chunk + 1) * ROWS_A_THREAD, height)):
        if nnf[y, x, 0] >= 0:
            total_delta += delta[y, x]
            total_omega_sum += omega_sums[nnf[y, x, 0], nnf[y, x, 1]]
            patches += 1
    if patches:
        cuda.atomic.add(sums, (x, 0), total_delta)
        cuda.atomic.add(sums, (x, 1), total_omega_sum)
        cuda.atomic.add(sums, (x, 2), patches)


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "energy", sum_columns_kernel, (NNF, DELTA, MAP, TOTALS)


def energy(nnf, delta, omega_sums):
    """As :func:`stylit_ref.passes.energy`, on device arrays."""
    height, width = delta.shape
    sums = zeros((width, 3), np.int64)
    launch(sum_columns_kernel, (-(-height // ROWS_A_THREAD), width), nnf, delta, omega_sums, sums)
    # Python's integers: the sum over all columns may pass 64 bits.
    total_delta, total_omega_sum, patches = sums.copy_to_host().astype(object).sum(axis=0)
    return total_delta / patches, total_omega_sum / patches
