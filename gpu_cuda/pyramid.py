"""Image pyramid and the step from one level to the next (Kernel_Downsample, Kernel_Upsample)."""

import numpy as np
from numba import cuda

from gpu_cuda.device import launch
from gpu_cuda.formulae import clamp
from gpu_cuda.memory import empty


@cuda.jit
def downsample_kernel(image, half):
    x, y = cuda.grid(2)
    if y >= half.shape[0] or x >= half.shape[1]:
        return
    for c in range(half.shape[2]):
        total = (
            np.int32(image[2 * y, 2 * x, c])
            + np.int32(image[2 * y, 2 * x + 1, c])
            + np.int32(image[2 * y + 1, 2 * x, c])
            + np.int32(image[2 * y + 1, 2 * x + 1, c])
        )
        half[y, x, c] = (total + 2) // 4


def downsample(image):
    """As :func:`stylit_ref.passes.downsample`, on device arrays."""
    height, width, channels = image.shape
    half = empty((height // 2, width // 2, channels), np.uint8)
    launch(downsample_kernel, half.shape[:2], image, half)
    return half


@cuda.jit
def upsample_nnf_kernel(coarse_nnf, nnf, radius, source_height, source_width):
    x, y = cuda.grid(2)
    if y >= nnf.shape[0] or x >= nnf.shape[1] or nnf[y, x, 0] < 0:
        return
    parent_y = min(y // 2, coarse_nnf.shape[0] - 1)
    parent_x = min(x // 2, coarse_nnf.shape[1] - 1)
    fine_y = 2 * coarse_nnf[parent_y, parent_x, 0] + (y - 2 * parent_y)
    fine_x = 2 * coarse_nnf[parent_y, parent_x, 1] + (x - 2 * parent_x)
    nnf[y, x, 0] = clamp(fine_y, radius, source_height - 1 - radius)
    nnf[y, x, 1] = clamp(fine_x, radius, source_width - 1 - radius)


def upsample_nnf(coarse_nnf, nnf, patch_width, source_height, source_width):
    """As :func:`stylit_ref.passes.upsample_nnf`, on device arrays."""
    arguments = coarse_nnf, nnf, patch_width // 2, source_height, source_width
    launch(upsample_nnf_kernel, nnf.shape[:2], *arguments)
