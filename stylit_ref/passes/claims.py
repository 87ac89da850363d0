"""Source patches claim target patches (StyLit, as told in Hauptfleisch 2020, 2.3.1)."""

from functools import lru_cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.formulae.claim_state import ASKING, LOST
from stylit_ref.machine.kernel import kernel
from stylit_ref.metric.fast_metric import make_fast_metric
from stylit_ref.metric.textures import Textures, vector_sizes

FREE, FIXED, CLAIMED = 0, 1, 2
"""The state of a target patch; a retrieval may only take ``FREE`` ones."""


@kernel(parallel=False)
def settle_claims(
    claims: NDArray[np.int32],
    errors: NDArray[np.int64],
    last_error: int,
    last_claims: int,
    limits: NDArray[np.int64],
    taken: NDArray[np.uint8],
    patch_width: int,
    nnf: NDArray[np.int32],
    delta: NDArray[np.int64],
) -> None:
    """Give each free target patch to the closest of the source patches that claim it.

    As many claims count as the error budget covers, from the smallest error on; equal errors rank
    in the order of rows. Of two claims to a patch the one with the smaller error wins, or the
    earlier one.

    Parameters
    ----------
    claims : (H_A - 2 radius, W_A - 2 radius, 2) int32
        The target patch that each source patch claims.
    errors : (H_A - 2 radius, W_A - 2 radius) int64
        Their δ.
    last_error, last_claims : int
        The largest error within the budget, and the number of claims of just that error within it.
    limits : (H_B, W_B) int64
        The largest error that a target patch accepts.
    taken : (H_B, W_B) uint8
        ``FREE`` or ``FIXED``; becomes ``CLAIMED`` for each settled claim.
    patch_width : int
    nnf, delta : (H_B, W_B, 2) int32 and (H_B, W_B) int64
        Receive the settled assignments.
    """
    radius = patch_width // 2
    for y in range(errors.shape[0]):
        for x in range(errors.shape[1]):
            error = errors[y, x]
            target_y, target_x = claims[y, x, 0], claims[y, x, 1]
            if taken[target_y, target_x] == FIXED or error > last_error:
                continue
            if error == last_error:
                if last_claims == 0:
                    continue
                last_claims -= 1
            if error > limits[target_y, target_x]:
                continue
            if taken[target_y, target_x] == FREE or error < delta[target_y, target_x]:
                taken[target_y, target_x] = CLAIMED
                nnf[target_y, target_x, 0], nnf[target_y, target_x, 1] = y + radius, x + radius
                delta[target_y, target_x] = error


@kernel(parallel=False)
def invert_nnf(
    nnf: NDArray[np.int32],
    delta: NDArray[np.int64],
    patch_width: int,
    inverse: NDArray[np.int32],
    inverse_delta: NDArray[np.int64],
) -> None:
    """Invert an NNF: each source patch gets the closest of the target patches assigned to it.

    Parameters
    ----------
    nnf, delta : (H_B, W_B, 2) int32 and (H_B, W_B) int64
        Negative where a mask leaves the pixel alone.
    patch_width : int
    inverse : (H_A - 2 radius, W_A - 2 radius, 2) int32
        As ``claims`` of :func:`settle_claims`; overwritten if a target patch is assigned to the
        source patch and is closer.
    inverse_delta : (H_A - 2 radius, W_A - 2 radius) int64
        Their δ; a value that is already there stays only if it is lower.
    """
    radius = patch_width // 2
    for y in range(delta.shape[0]):
        for x in range(delta.shape[1]):
            if nnf[y, x, 0] < 0:
                continue
            source_y, source_x = nnf[y, x, 0] - radius, nnf[y, x, 1] - radius
            if delta[y, x] < inverse_delta[source_y, source_x]:
                inverse[source_y, source_x, 0], inverse[source_y, source_x, 1] = y, x
                inverse_delta[source_y, source_x] = delta[y, x]


@lru_cache
def _make_errors_kernel(patch_width, channels, moments_a_patch, mean_channels):
    radius = patch_width // 2
    error_of = make_fast_metric(
        patch_width, channels, moments_a_patch, mean_channels
    ).assignment_delta

    @kernel(patch_width, channels, moments_a_patch, mean_channels)
    def claim_errors_kernel(textures, claims, errors):
        for y in prange(errors.shape[0]):
            for x in range(errors.shape[1]):
                errors[y, x] = error_of(
                    textures, claims[y, x, 0], claims[y, x, 1], y + radius, x + radius
                )

    return claim_errors_kernel


def claim_errors(
    textures: Textures, patch_width: int, claims: NDArray[np.int32], errors: NDArray[np.int64]
) -> None:
    """Evaluate δ of every claim.

    Parameters
    ----------
    textures : Textures
    patch_width : int
    claims : (H_A - 2 radius, W_A - 2 radius, 2) int32
        As for :func:`settle_claims`.
    errors : (H_A - 2 radius, W_A - 2 radius) int64
        Receives δ in fixed point.
    """
    _make_errors_kernel(*vector_sizes(textures, patch_width))(textures, claims, errors)


@kernel()
def lose_claims(
    claims: NDArray[np.int32], taken: NDArray[np.uint8], states: NDArray[np.uint8]
) -> None:
    """Let every source patch know whose claim is to a target patch that has become fixed.

    Parameters
    ----------
    claims : (H_A - 2 radius, W_A - 2 radius, 2) int32
    taken : (H_B, W_B) uint8
        ``FREE`` or ``FIXED``.
    states : (H_A - 2 radius, W_A - 2 radius) uint8
        :mod:`stylit_ref.formulae.claim_state`, updated in place.
    """
    for y in prange(states.shape[0]):
        for x in range(states.shape[1]):
            if states[y, x] < LOST and taken[claims[y, x, 0], claims[y, x, 1]] != FREE:
                states[y, x] |= np.uint8(LOST | ASKING)
