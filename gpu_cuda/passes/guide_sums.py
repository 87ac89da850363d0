"""Means of the guides over every patch, as sums (Kernel_EvaluateMeans, thesis 5.2.2)."""

from numba import cuda

from gpu_cuda.formulae import patch_sum
from gpu_cuda.host.argument_types import IMAGE, INT, SUMS
from gpu_cuda.host.device import launch


@cuda.jit
def means_kernel(texture, sums, patch_width, first):
    x, y = cuda.grid(2)
    if y > texture.shape[0] - patch_width or x > texture.shape[1] - patch_width:
        return
    for c in range(sums.shape[2]):
        sums[first + y, first + x, c] = patch_sum(texture, y, x, c, patch_width)


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "means", means_kernel, (IMAGE, SUMS, INT, INT)


def means(texture, sums, patch_width, first):
    """As :func:`stylit_ref.passes.means`, on device arrays."""
    launch(means_kernel, texture.shape[:2], texture, sums, patch_width, first)
