"""Random search around each assignment (Kernel_RandomSearch, thesis 3.3, 5.1)."""

from functools import lru_cache

from numba import cuda

from gpu_cuda.formulae import (
    penalization,
    random_candidate,
    random_words,
    search_draw,
    search_radius,
    search_words,
)
from gpu_cuda.host.argument_types import INT, SEARCH, STREAM
from gpu_cuda.host.device import BLOCK, compiled_for, formula
from gpu_cuda.metric.constants import MetricConstants
from gpu_cuda.metric.improve_proposal import make_improve_proposal
from gpu_cuda.metric.launch_search import launch_search
from gpu_cuda.metric.target_patches import make_target_patch
from stylit_ref.formulae.search_radii import number_of_radii
from stylit_ref.metric.proposal import Proposal


@lru_cache
def make_kernel(constants, block=BLOCK, shared=False):
    """Compile Kernel_RandomSearch; parameters as in :mod:`gpu_cuda.passes.propagation`."""
    radius = constants.radius
    improve_proposal = formula(make_improve_proposal(constants))
    target_patch = make_target_patch(constants, block, shared)

    @compiled_for(block)
    def random_search_kernel(
        source, target, weights, guide_map, target_sums, source_sums, omega_sums,
        occurrence_weight, nnf, delta, new_nnf, new_delta, stream, radii,
    ):  # fmt: skip
        x, y = cuda.grid(2)
        height, width = delta.shape
        patch = target_patch(target, width, y, x)
        if y >= height or x >= width:
            return
        source_height, source_width = omega_sums.shape
        metric = source, source_width, weights, guide_map, target_sums, source_sums
        best_y, best_x, best_delta = nnf[y, x, 0], nnf[y, x, 1], delta[y, x]
        if best_y >= 0:
            best_phi = best_delta + penalization(omega_sums, occurrence_weight, best_y, best_x)
            for k in range(radii):
                draw = random_words(stream, y * width + x, search_draw(k))
                word_y, word_x = search_words(draw, k)
                candidate_y, candidate_x = random_candidate(
                    word_y, word_x, nnf[y, x, 0], nnf[y, x, 1], search_radius(k),
                    radius, source_height, source_width,
                )  # fmt: skip
                best_y, best_x, best_delta, best_phi = improve_proposal(
                    (metric, patch), omega_sums, occurrence_weight, y, x,
                    candidate_y, candidate_x, best_y, best_x, best_delta, best_phi,
                )  # fmt: skip
        new_nnf[y, x, 0], new_nnf[y, x, 1], new_delta[y, x] = best_y, best_x, best_delta

    return random_search_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    arguments = *SEARCH, STREAM, INT
    plain = MetricConstants.of_sizes(sizes)
    with_map = MetricConstants.of_sizes(sizes, with_map=True)
    yield "random_search", make_kernel(plain, sizes.block), arguments
    yield "random_search, shared", make_kernel(plain, sizes.block, shared=True), arguments
    yield "random_search, guide map", make_kernel(with_map, sizes.block), arguments


def random_search(
    textures, omega_sums, occurrence_weight, patch_width,
    nnf, delta, new_nnf, new_delta, stream, side=None,
):  # fmt: skip
    """As :func:`stylit_ref.passes.random_search`, on device arrays."""
    proposal = Proposal(
        textures, omega_sums, occurrence_weight, patch_width, nnf, delta, new_nnf, new_delta
    )
    launch_search(make_kernel, proposal, stream, number_of_radii(side or max(delta.shape)))
