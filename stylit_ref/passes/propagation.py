"""Propagation of assignments to neighbours at a distance (Kernel_Propagation, 3.3)."""

from functools import lru_cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.formulae.candidates import neighbour_offsets, propagation_candidate
from stylit_ref.formulae.patch_penalization import penalization
from stylit_ref.machine.kernel import kernel
from stylit_ref.metric.fast_metric import make_fast_metric
from stylit_ref.metric.textures import Textures, vector_sizes


@lru_cache
def _make_kernel(patch_width, channels, moments_a_patch, mean_channels):
    radius = patch_width // 2
    improve_proposal = make_fast_metric(
        patch_width, channels, moments_a_patch, mean_channels
    ).improve_proposal

    # Separate arguments: Numba allows no named tuple inside another in a prange loop.
    @kernel(patch_width, channels, moments_a_patch, mean_channels)
    def propagation_kernel(
        textures, omega_sums, occurrence_weight, nnf, delta, new_nnf, new_delta, distance
    ):
        height, width = delta.shape
        source_height, source_width = omega_sums.shape
        for y in prange(height):
            for x in range(width):
                best_y, best_x = np.int64(nnf[y, x, 0]), np.int64(nnf[y, x, 1])
                best_delta = delta[y, x]
                if best_y >= 0:
                    best_phi = best_delta + penalization(
                        omega_sums, occurrence_weight, best_y, best_x
                    )
                    for dy, dx in neighbour_offsets(distance):
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
                            textures, omega_sums, occurrence_weight, y, x,
                            candidate_y, candidate_x, best_y, best_x, best_delta, best_phi,
                        )  # fmt: skip
                new_nnf[y, x, 0], new_nnf[y, x, 1], new_delta[y, x] = best_y, best_x, best_delta

    return propagation_kernel


def propagation(
    textures: Textures,
    omega_sums: NDArray[np.int32],
    occurrence_weight: int,
    patch_width: int,
    nnf: NDArray[np.int32],
    delta: NDArray[np.int64],
    new_nnf: NDArray[np.int32],
    new_delta: NDArray[np.int64],
    distance: int,
) -> None:
    """Offer every target patch the assignments of four neighbours, shifted back.

    Ω does not change during the pass. Candidates come in the thesis' order: the neighbours to the
    right, below, to the left, above.

    Parameters
    ----------
    textures : Textures
    omega_sums : (H_A, W_A) int32
        W, Ω summed over each patch.
    occurrence_weight : int
        Weight of W in φ, fixed point.
    patch_width : int
    nnf : (H_B, W_B, 2) int32
        Assignments to start from; negative where a mask leaves the pixel alone.
    delta : (H_B, W_B) int64
        Their δ.
    new_nnf, new_delta : arrays like ``nnf`` and ``delta``
        NNF' of the thesis: receives the better assignment and its δ.
    distance : int
        Offset of the neighbours in pixels (4, 2 and 1 in the thesis' jump flood).
    """
    run = _make_kernel(*vector_sizes(textures, patch_width))
    run(textures, omega_sums, occurrence_weight, nnf, delta, new_nnf, new_delta, distance)
