"""δ of the assignments as they stand (thesis 2.1)."""

from functools import lru_cache

from numba import cuda

from gpu_cuda.device import launch
from gpu_cuda.formulae import make_assignment_delta
from gpu_cuda.metric import constants, metric_arrays


@lru_cache
def make_kernel(patch_width, mean_channels):
    """Compile the kernel for a patch width and the guide channels that have means."""
    assignment_delta = make_assignment_delta(mean_channels)

    @cuda.jit
    def similarity_kernel(source, target, weights, guide_map, target_sums, source_sums, nnf, delta):
        x, y = cuda.grid(2)
        if y < delta.shape[0] and x < delta.shape[1] and nnf[y, x, 0] >= 0:
            delta[y, x] = assignment_delta(
                source, target, weights, guide_map, target_sums, source_sums, patch_width,
                y, x, y, x, nnf[y, x, 0], nnf[y, x, 1],
            )  # fmt: skip

    return similarity_kernel


def similarity(textures, patch_width, nnf, delta):
    """As :func:`stylit_ref.passes.similarity`, on device arrays."""
    _, _, mean_channels = constants(textures, patch_width)
    kernel = make_kernel(patch_width, mean_channels)
    launch(kernel, delta.shape, *metric_arrays(textures), nnf, delta)
