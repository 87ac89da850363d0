"""Random search around each claim of a source patch (StyLit's retrievals)."""

from functools import lru_cache

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray

from stylit_ref.formulae.claim_state import LOST, next_state
from stylit_ref.formulae.search_radii import (
    number_of_radii,
    search_draw,
    search_radius,
)
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.prefetch import prefetch
from stylit_ref.metric.fast_metric import make_delta_bound, make_fast_metric
from stylit_ref.metric.lower_bound import BOUND_SCALE, LINE_MOMENTS
from stylit_ref.metric.prefetch_patch import NEAR, make_prefetch_patch
from stylit_ref.metric.textures import Textures, vector_sizes
from stylit_ref.randomness.neighbouring_words import LANES, neighbouring_words
from stylit_ref.randomness.philox import FourWords, uniform_below

# As in random_search.py, a few source patches take each step together: draw, fetch, bound, fetch
# what the bound leaves, evaluate. As many as draw their random words in one vector.
PATCHES_A_BATCH = LANES

_NO_LIMIT = np.iinfo(np.int64).max


@lru_cache
def _make_kernel(patch_width, channels, moments_a_patch, mean_channels):
    radius = patch_width // 2
    error_of = make_fast_metric(
        patch_width, channels, moments_a_patch, mean_channels
    ).assignment_delta
    bound_of = make_delta_bound(moments_a_patch)
    prefetch_patch = make_prefetch_patch(patch_width, channels)

    @njit(forceinline=True)
    def draw_coordinate(words, centres, reach, length, drawn):
        """As :func:`stylit_ref.formulae.candidates.random_candidate`, for a batch."""
        for i in range(PATCHES_A_BATCH):
            first = max(centres[i] - reach, np.int32(0))
            last = min(centres[i] + reach, length - np.int32(1))
            drawn[i] = first + np.int32(uniform_below(words[i], np.uint32(last - first + 1)))

    @kernel(patch_width, channels, moments_a_patch, mean_channels)
    def search_claims_kernel(
        textures, taken, claims, errors, states, new_claims, new_errors, new_states,
        stream, far,
        all_words, all_centres, all_drawn, all_candidates, all_bounds, all_counts,
    ):  # fmt: skip
        height, width = errors.shape
        target_height, target_width = np.int32(taken.shape[0]), np.int32(taken.shape[1])
        radii = all_drawn.shape[1]
        for y in prange(height):
            words, centres, drawn = all_words[y], all_centres[y], all_drawn[y]
            candidates, bounds, counts = all_candidates[y], all_bounds[y], all_counts[y]
            for first_x in range(0, width, PATCHES_A_BATCH):
                batch = min(PATCHES_A_BATCH, width - first_x)
                for i in range(batch):
                    centres[0, i] = claims[y, first_x + i, 0]
                    centres[1, i] = claims[y, first_x + i, 1]
                for k in range(radii):
                    if k == 0 or search_draw(k) != search_draw(k - 1):
                        pixel = np.uint32(y * width + first_x)
                        neighbouring_words(words, stream, pixel, np.uint32(search_draw(k)))
                    own, reach = words[2 * (k % 2) :], np.int32(search_radius(k))
                    draw_coordinate(own[0], centres[0], reach, target_height, drawn[k, 0])
                    draw_coordinate(own[1], centres[1], reach, target_width, drawn[k, 1])
                for i in range(batch):
                    x = first_x + i
                    lost = states[y, x] >= LOST
                    count = 0
                    if lost or errors[y, x] > 0:
                        for k in range(radii):
                            target_y, target_x = drawn[k, 0, i], drawn[k, 1, i]
                            candidates[i, count, 0], candidates[i, count, 1] = target_y, target_x
                            count += taken[target_y, target_x] == 0
                        if lost and not count:  # then the fixed ones compete
                            for k in range(radii):
                                candidates[i, k, 0] = drawn[k, 0, i]
                                candidates[i, k, 1] = drawn[k, 1, i]
                            count = radii
                    counts[i] = count
                    for k in range(count):
                        place = candidates[i, k, 0] * np.int64(target_width) + candidates[i, k, 1]
                        for line in range(0, moments_a_patch, LINE_MOMENTS):
                            prefetch(textures.target_moments, place * moments_a_patch + line)
                for i in range(batch):
                    x = first_x + i
                    limit = errors[y, x] * BOUND_SCALE
                    if (
                        states[y, x] >= LOST
                        and counts[i]
                        and not taken[candidates[i, 0, 0], candidates[i, 0, 1]]
                    ):
                        limit = _NO_LIMIT
                    count = 0
                    for k in range(counts[i]):
                        target_y, target_x = np.int64(candidates[i, k, 0]), candidates[i, k, 1]
                        bound = bound_of(textures, target_y, target_x, y + radius, x + radius)
                        bounds[i, count] = bound
                        candidates[i, count, 0], candidates[i, count, 1] = target_y, target_x
                        count += bound < limit
                    counts[i] = count
                    if far:
                        for k in range(count):
                            prefetch_patch(
                                textures.target, candidates[i, k, 0], candidates[i, k, 1]
                            )
                for i in range(batch):
                    x = first_x + i
                    best_y, best_x = np.int64(claims[y, x, 0]), np.int64(claims[y, x, 1])
                    least, lost = errors[y, x], states[y, x] >= LOST
                    changed = False
                    for k in range(counts[i]):
                        target_y, target_x = np.int64(candidates[i, k, 0]), candidates[i, k, 1]
                        freed = lost and not taken[target_y, target_x]
                        if not freed and bounds[i, k] >= least * BOUND_SCALE:
                            continue
                        if target_y == best_y and target_x == best_x:
                            continue
                        error = error_of(textures, target_y, target_x, y + radius, x + radius)
                        if freed or error < least:
                            best_y, best_x, least = target_y, target_x, error
                            lost, changed = lost and not freed, True
                    new_claims[y, x, 0], new_claims[y, x, 1] = best_y, best_x
                    new_errors[y, x] = least
                    new_states[y, x] = next_state(states[y, x], 0, changed, lost)

    return search_claims_kernel


def search_claims(
    textures: Textures,
    taken: NDArray[np.uint8],
    patch_width: int,
    claims: NDArray[np.int32],
    errors: NDArray[np.int64],
    states: NDArray[np.uint8],
    new_claims: NDArray[np.int32],
    new_errors: NDArray[np.int64],
    new_states: NDArray[np.uint8],
    stream: FourWords,
) -> None:
    """Offer every source patch random target patches at radius 1, 2, 4, ... around its claim.

    It decides as :func:`stylit_ref.passes.random_search.random_search` would with source and target
    in each other's place, and any free target patch better than all fixed ones. The radius doubles
    up to half the larger side of the target.

    Parameters
    ----------
    textures : Textures
    taken : (H_B, W_B) uint8
        ``FREE`` or ``FIXED``.
    patch_width : int
    claims, errors, states, new_claims, new_errors, new_states : arrays
        As for :func:`stylit_ref.passes.claim_propagation.propagate_claims`.
    stream : tuple of 4 uint32
        From :func:`stylit_ref.randomness.random_stream.random_stream`.
    """
    run = _make_kernel(*vector_sizes(textures, patch_width))
    height, batch = errors.shape[0], PATCHES_A_BATCH
    radii = number_of_radii(max(taken.shape))
    run(
        textures, taken, claims, errors, states, new_claims, new_errors, new_states, stream,
        textures.target.nbytes > NEAR,
        np.empty((height, 4, batch), np.uint32),
        np.zeros((height, 2, batch), np.int32),
        np.empty((height, radii, 2, batch), np.int32),
        np.empty((height, batch, radii, 2), np.int32),
        np.empty((height, batch, radii), np.int64),
        np.empty((height, batch), np.int32),
    )  # fmt: skip
