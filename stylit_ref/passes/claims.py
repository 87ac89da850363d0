"""Source patches claim target patches (StyLit, as told in Hauptfleisch 2020, 2.3.1)."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel

FREE, FIXED, CLAIMED = 0, 1, 2
"""The state of a target patch; a retrieval may only take ``FREE`` ones."""


@kernel(parallel=False)
def settle_claims(
    claims: NDArray[np.int32],
    errors: NDArray[np.int64],
    last_error: int,
    last_claims: int,
    limits: NDArray[np.int64],
    taken: NDArray[np.int32],
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
        The target patch that each source patch claims, ``radius`` added to its coordinates.
    errors : (H_A - 2 radius, W_A - 2 radius) int64
        Their δ.
    last_error, last_claims : int
        The largest error within the budget, and the number of claims of just that error within it.
    limits : (H_B, W_B) int64
        The largest error that a target patch accepts.
    taken : (H_B + 2 radius, W_B + 2 radius) int32
        ``FREE`` or ``FIXED``; becomes ``CLAIMED`` for each settled claim.
    patch_width : int
    nnf, delta : (H_B, W_B, 2) int32 and (H_B, W_B) int64
        Receive the settled assignments.
    """
    radius = patch_width // 2
    for y in range(errors.shape[0]):
        for x in range(errors.shape[1]):
            error = errors[y, x]
            padded_y, padded_x = claims[y, x, 0], claims[y, x, 1]
            if taken[padded_y, padded_x] == FIXED or error > last_error:
                continue
            if error == last_error:
                if last_claims == 0:
                    continue
                last_claims -= 1
            target_y, target_x = padded_y - radius, padded_x - radius
            if error > limits[target_y, target_x]:
                continue
            if taken[padded_y, padded_x] == FREE or error < delta[target_y, target_x]:
                taken[padded_y, padded_x] = CLAIMED
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
                inverse[source_y, source_x, 0] = y + radius
                inverse[source_y, source_x, 1] = x + radius
                inverse_delta[source_y, source_x] = delta[y, x]
