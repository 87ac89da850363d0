"""Image pyramid and the step from one level to the next (Kernel_Downsample, Kernel_Upsample)."""

import numpy as np
from numba import cuda

from gpu_cuda.formulae import block_mean, upsampled_assignment
from gpu_cuda.host.argument_types import IMAGE, INT, NNF
from gpu_cuda.host.device import launch
from gpu_cuda.host.memory import empty


@cuda.jit
def downsample_kernel(image, half):
    x, y = cuda.grid(2)
    if y >= half.shape[0] or x >= half.shape[1]:
        return
    for c in range(half.shape[2]):
        half[y, x, c] = block_mean(image, y, x, c)


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "downsample", downsample_kernel, (IMAGE, IMAGE)
    yield "upsample NNF", upsample_nnf_kernel, (NNF, NNF, INT, INT, INT)


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
    nnf[y, x, 0], nnf[y, x, 1] = upsampled_assignment(
        coarse_nnf, y, x, radius, source_height, source_width
    )


def upsample_nnf(coarse_nnf, nnf, patch_width, source_height, source_width):
    """As :func:`stylit_ref.passes.upsample_nnf`, on device arrays."""
    arguments = coarse_nnf, nnf, patch_width // 2, source_height, source_width
    launch(upsample_nnf_kernel, nnf.shape[:2], *arguments)
