"""Propagation of assignments to neighbours at a distance (Kernel_Propagation, thesis 3.3, 5.1)."""

from functools import lru_cache

from numba import cuda

from gpu_cuda.formulae import penalization, propagation_candidate
from gpu_cuda.host.argument_types import INT, SEARCH
from gpu_cuda.host.device import BLOCK, compiled_for, formula
from gpu_cuda.metric.constants import MetricConstants
from gpu_cuda.metric.improve_proposal import make_improve_proposal
from gpu_cuda.metric.launch_search import launch_search
from gpu_cuda.metric.target_patches import make_target_patch
from stylit_ref.metric.proposal import Proposal


@lru_cache
def make_kernel(constants, block=BLOCK, shared=False):
    """Compile Kernel_Propagation.

    Parameters
    ----------
    constants : gpu_cuda.metric.constants.MetricConstants
    block : (int, int)
        Threads of a block along x and y.
    shared : bool
        Whether a block reads its target patches from shared memory (5.1).
    """
    radius = constants.radius
    improve_proposal = formula(make_improve_proposal(constants))
    target_patch = make_target_patch(constants, block, shared)

    @compiled_for(block)
    def propagation_kernel(
        source, target, weights, guide_map, target_sums, source_sums, omega_sums,
        occurrence_weight, nnf, delta, new_nnf, new_delta, distance,
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
            for dy, dx in ((0, distance), (distance, 0), (0, -distance), (-distance, 0)):
                near_y, near_x = y + dy, x + dx
                if near_y < 0 or near_y >= height or near_x < 0 or near_x >= width:
                    continue
                if nnf[near_y, near_x, 0] < 0:
                    continue
                candidate_y, candidate_x = propagation_candidate(
                    nnf[near_y, near_x, 0], nnf[near_y, near_x, 1], dy, dx,
                    radius, source_height, source_width,
                )  # fmt: skip
                best_y, best_x, best_delta, best_phi = improve_proposal(
                    (metric, patch), omega_sums, occurrence_weight, y, x,
                    candidate_y, candidate_x, best_y, best_x, best_delta, best_phi,
                )  # fmt: skip
        new_nnf[y, x, 0], new_nnf[y, x, 1], new_delta[y, x] = best_y, best_x, best_delta

    return propagation_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    arguments = *SEARCH, INT
    plain = MetricConstants.of_sizes(sizes)
    with_map = MetricConstants.of_sizes(sizes, with_map=True)
    yield "propagation", make_kernel(plain, sizes.block), arguments
    yield "propagation, shared", make_kernel(plain, sizes.block, shared=True), arguments
    yield "propagation, guide map", make_kernel(with_map, sizes.block), arguments


def propagation(
    textures, omega_sums, occurrence_weight, patch_width, nnf, delta, new_nnf, new_delta, distance
):
    """As :func:`stylit_ref.passes.propagation`, on device arrays."""
    proposal = Proposal(
        textures, omega_sums, occurrence_weight, patch_width, nnf, delta, new_nnf, new_delta
    )
    launch_search(make_kernel, proposal, distance)
