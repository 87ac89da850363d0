"""Propagation of assignments to neighbours at a distance (Kernel_Propagation, thesis 3.3, 5.1)."""

from functools import lru_cache

import numpy as np
from numba import cuda

from gpu_cuda.device import BLOCK, compiled_for
from gpu_cuda.formulae import make_improve_proposal, penalization, propagation_candidate
from gpu_cuda.metric import launch_search
from gpu_cuda.shared_tile import fill_tile, tile_shape


@lru_cache
def make_kernel(patch_width, channels, mean_channels, block=BLOCK, shared=False):
    """Compile Kernel_Propagation.

    Parameters
    ----------
    patch_width, channels, mean_channels : int
        See :func:`gpu_cuda.metric.constants`.
    block : (int, int)
        Threads of a block along x and y.
    shared : bool
        Whether a block reads its target patches from shared memory (5.1).
    """
    radius = patch_width // 2
    improve_proposal = make_improve_proposal(mean_channels)
    tile = tile_shape(block, radius, channels) if shared else (1, 1, 1)

    @compiled_for(block)
    def propagation_kernel(
        source, target, weights, guide_map, target_sums, source_sums, omega_sums,
        occurrence_weight, nnf, delta, new_nnf, new_delta, distance,
    ):  # fmt: skip
        x, y = cuda.grid(2)
        patches, patch_y, patch_x = target, y, x
        if shared:
            patches = cuda.shared.array(tile, np.uint8)
            patch_y, patch_x = cuda.threadIdx.y, cuda.threadIdx.x
            fill_tile(target, patches, radius, y - patch_y, x - patch_x, patch_y, patch_x)
            cuda.syncthreads()
        height, width = delta.shape
        if y >= height or x >= width:
            return
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
                    radius, omega_sums.shape[0], omega_sums.shape[1],
                )  # fmt: skip
                best_y, best_x, best_delta, best_phi = improve_proposal(
                    source, patches, weights, guide_map, target_sums, source_sums, omega_sums,
                    occurrence_weight, patch_width, y, x, patch_y, patch_x,
                    candidate_y, candidate_x, best_y, best_x, best_delta, best_phi,
                )  # fmt: skip
        new_nnf[y, x, 0], new_nnf[y, x, 1], new_delta[y, x] = best_y, best_x, best_delta

    return propagation_kernel


def propagation(
    textures, omega_sums, occurrence_weight, patch_width, nnf, delta, new_nnf, new_delta, distance
):
    """As :func:`stylit_ref.passes.propagation`, on device arrays."""
    launch_search(
        make_kernel, textures, omega_sums, occurrence_weight, patch_width,
        nnf, delta, new_nnf, new_delta, distance,
    )  # fmt: skip
