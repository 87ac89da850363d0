"""δ of the assignments as they stand (thesis 2.1)."""

from functools import lru_cache

from numba import cuda

from gpu_cuda.host.argument_types import DELTA, INT, METRIC, NNF
from gpu_cuda.host.device import formula, launch
from gpu_cuda.metric.constants import MetricConstants
from gpu_cuda.metric.improve_proposal import NO_LIMIT, make_assignment_delta
from gpu_cuda.metric.target_patches import make_target_patch
from gpu_cuda.metric.textures import metric_arrays


@lru_cache
def make_kernel(constants):
    """Compile the kernel for a level's :class:`gpu_cuda.metric.constants.MetricConstants`."""
    assignment_delta = formula(make_assignment_delta(constants))
    target_patch = make_target_patch(constants, None, shared=False)

    @cuda.jit
    def similarity_kernel(
        source, target, weights, guide_map, target_sums, source_sums, source_width, nnf, delta
    ):
        x, y = cuda.grid(2)
        height, width = delta.shape
        if y < height and x < width and nnf[y, x, 0] >= 0:
            metric = source, source_width, weights, guide_map, target_sums, source_sums
            delta[y, x] = assignment_delta(
                metric, target_patch(target, width, y, x), y, x,
                nnf[y, x, 0], nnf[y, x, 1], NO_LIMIT,
            )  # fmt: skip

    return similarity_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    arguments = *METRIC, INT, NNF, DELTA
    yield "similarity", make_kernel(MetricConstants.of_sizes(sizes)), arguments
    with_map = MetricConstants.of_sizes(sizes, with_map=True)
    yield "similarity, guide map", make_kernel(with_map), arguments


def similarity(textures, patch_width, nnf, delta):
    """As :func:`stylit_ref.passes.similarity`, on device arrays."""
    kernel = make_kernel(MetricConstants.of(textures, patch_width))
    launch(kernel, delta.shape, *metric_arrays(textures), textures.source.shape[1], nnf, delta)
