"""The guide map G of a level (Kernel_EvaluateMap, thesis 5.2.2)."""

from numba import cuda

from gpu_cuda.formulae import scaled_variance
from gpu_cuda.host.argument_types import IMAGE, INT, NUMBERS, SUMS, WHITE
from gpu_cuda.host.device import launch
from stylit_ref.formulae.guide_map import variance_limit


@cuda.jit
def guide_map_kernel(texture, sums, weights, patch_width, limit, white):
    x, y = cuda.grid(2)
    if y < white.shape[0] and x < white.shape[1]:
        white[y, x] = scaled_variance(texture, sums[y, x], weights, y, x, patch_width) < limit


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "guide map", guide_map_kernel, (IMAGE, SUMS, NUMBERS, INT, INT, WHITE)


def guide_map(texture, sums, weights, patch_width, epsilon, white):
    """As :func:`stylit_ref.passes.guide_map`, on device arrays."""
    limit = variance_limit(epsilon, patch_width)
    launch(guide_map_kernel, white.shape, texture, sums, weights, patch_width, limit, white)
