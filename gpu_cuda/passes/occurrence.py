"""The occurrence map Ω of a whole NNF, and its sums over patches (thesis 2.1, 3.2).

The thesis makes Ω on the host, since atomic additions over whole patches collide. Here only
patch centres are counted, which collide little; two box sums do the rest on the device.
"""

from functools import lru_cache

import numpy as np
from numba import cuda

from gpu_cuda.host.argument_types import MAP, NNF
from gpu_cuda.host.device import launch
from gpu_cuda.host.memory import fill


@cuda.jit
def count_kernel(nnf, counts):
    x, y = cuda.grid(2)
    if y < nnf.shape[0] and x < nnf.shape[1] and nnf[y, x, 0] >= 0:
        cuda.atomic.add(counts, (nnf[y, x, 0], nnf[y, x, 1]), 1)


@lru_cache
def make_box_sum_kernel(patch_width):
    """Compile the sum over the patch around each pixel."""
    radius = patch_width // 2

    @cuda.jit
    def box_sum_kernel(values, sums):
        x, y = cuda.grid(2)
        height, width = values.shape
        if y >= height or x >= width:
            return
        total = np.int32(0)
        for near_y in range(max(y - radius, 0), min(y + radius + 1, height)):
            for near_x in range(max(x - radius, 0), min(x + radius + 1, width)):
                total += values[near_y, near_x]
        sums[y, x] = total

    return box_sum_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "count assignments", count_kernel, (NNF, MAP)
    yield "box sum", make_box_sum_kernel(sizes.patch_width), (MAP, MAP)


def occurrence_map(nnf, omega, omega_sums, patch_width):
    """As :func:`stylit_ref.passes.occurrence_map`, on device arrays."""
    box_sum = make_box_sum_kernel(patch_width)
    counts = omega_sums  # until the last step overwrites them
    fill(counts, 0)
    launch(count_kernel, nnf.shape[:2], nnf, counts)
    launch(box_sum, omega.shape, counts, omega)
    launch(box_sum, omega.shape, omega, omega_sums)
