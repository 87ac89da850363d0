"""Propagation of claims between neighbouring source patches (StyLit's retrievals)."""

from functools import lru_cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.formulae.candidates import neighbour_offsets, propagation_candidate
from stylit_ref.formulae.claim_state import LOST, distance_bit, must_ask, next_state
from stylit_ref.machine.kernel import kernel
from stylit_ref.metric.fast_metric import make_fast_metric
from stylit_ref.metric.prefetch_patch import NEAR, make_prefetch_patch
from stylit_ref.metric.textures import Textures, vector_sizes

# Claims of neighbouring patches are scattered, so candidates are in no cache. A few source patches
# list theirs and fetch them from memory before the first is evaluated.
PATCHES_A_BATCH = 16
NEIGHBOURS = 4


@lru_cache
def _make_kernel(patch_width, channels, moments_a_patch, mean_channels):
    radius = patch_width // 2
    error_of = make_fast_metric(
        patch_width, channels, moments_a_patch, mean_channels
    ).assignment_delta
    prefetch_patch = make_prefetch_patch(patch_width, channels)

    @kernel(patch_width, channels, moments_a_patch, mean_channels)
    def propagate_claims_kernel(
        textures, taken, claims, errors, states, new_claims, new_errors, new_states,
        distance, bit, far, all_candidates, all_counts,
    ):  # fmt: skip
        height, width = errors.shape
        target_height, target_width = taken.shape
        for y in prange(height):
            candidates, counts = all_candidates[y], all_counts[y]
            for first_x in range(0, width, PATCHES_A_BATCH):
                batch = min(PATCHES_A_BATCH, width - first_x)
                for i in range(batch):
                    x = first_x + i
                    lost = states[y, x] >= LOST
                    count = 0
                    if lost or errors[y, x] > 0:
                        for dy, dx in neighbour_offsets(distance):
                            near_y, near_x = y + dy, x + dx
                            if near_y < 0 or near_y >= height or near_x < 0 or near_x >= width:
                                continue
                            if not must_ask(states[y, x], states[near_y, near_x], bit):
                                continue
                            target_y, target_x = propagation_candidate(
                                claims[near_y, near_x, 0], claims[near_y, near_x, 1], dy, dx,
                                0, target_height, target_width,
                            )  # fmt: skip
                            if target_y == claims[y, x, 0] and target_x == claims[y, x, 1]:
                                continue
                            if taken[target_y, target_x] and not lost:
                                continue
                            if far:
                                prefetch_patch(textures.target, target_y, target_x)
                            candidates[i, count, 0], candidates[i, count, 1] = target_y, target_x
                            count += 1
                    counts[i] = count
                for i in range(batch):
                    x = first_x + i
                    best_y, best_x = np.int64(claims[y, x, 0]), np.int64(claims[y, x, 1])
                    least, lost = errors[y, x], states[y, x] >= LOST
                    changed = False
                    for k in range(counts[i]):
                        target_y, target_x = np.int64(candidates[i, k, 0]), candidates[i, k, 1]
                        fixed = taken[target_y, target_x] > 0
                        if (fixed and not lost) or (target_y == best_y and target_x == best_x):
                            continue
                        error = error_of(textures, target_y, target_x, y + radius, x + radius)
                        if error < least or (lost and not fixed):
                            best_y, best_x, least, lost = target_y, target_x, error, fixed
                            changed = True
                    new_claims[y, x, 0], new_claims[y, x, 1] = best_y, best_x
                    new_errors[y, x] = least
                    new_states[y, x] = next_state(states[y, x], bit, changed, lost)

    return propagate_claims_kernel


def propagate_claims(
    textures: Textures,
    taken: NDArray[np.uint8],
    patch_width: int,
    claims: NDArray[np.int32],
    errors: NDArray[np.int64],
    states: NDArray[np.uint8],
    new_claims: NDArray[np.int32],
    new_errors: NDArray[np.int64],
    new_states: NDArray[np.uint8],
    distance: int,
) -> None:
    """Offer every source patch the claims of four neighbours, shifted back.

    It decides as :func:`stylit_ref.passes.propagation.propagation` would with source and target in
    each other's place, and any free target patch better than all fixed ones.

    Parameters
    ----------
    textures : Textures
    taken : (H_B, W_B) uint8
        ``FREE`` or ``FIXED``.
    patch_width : int
    claims : (H_A - 2 radius, W_A - 2 radius, 2) int32
        The target patch that each source patch claims.
    errors : (H_A - 2 radius, W_A - 2 radius) int64
        Their δ.
    states : (H_A - 2 radius, W_A - 2 radius) uint8
        :mod:`stylit_ref.formulae.claim_state`.
    new_claims, new_errors, new_states : arrays like ``claims``, ``errors`` and ``states``
        Receive the better claims.
    distance : int
        Offset of the neighbours in pixels, one of ``PROPAGATION_DISTANCES``.
    """
    run = _make_kernel(*vector_sizes(textures, patch_width))
    height = errors.shape[0]
    candidates = np.empty((height, PATCHES_A_BATCH, NEIGHBOURS, 2), np.int32)
    counts = np.empty((height, PATCHES_A_BATCH), np.int32)
    run(
        textures, taken, claims, errors, states, new_claims, new_errors, new_states,
        distance, distance_bit(distance), textures.target.nbytes > NEAR, candidates, counts,
    )  # fmt: skip
