"""Random search around each assignment (Kernel_RandomSearch, 3.3)."""

from functools import lru_cache

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray

from stylit_ref.formulae.candidates import random_candidate
from stylit_ref.formulae.patch_penalization import penalization
from stylit_ref.formulae.search_radii import (
    number_of_radii,
    search_draw,
    search_radius,
    search_words,
)
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.prefetch import prefetch
from stylit_ref.metric.fast_metric import make_fast_metric
from stylit_ref.metric.lower_bound import LINE_MOMENTS
from stylit_ref.metric.textures import Textures, vector_sizes
from stylit_ref.randomness.philox import FourWords
from stylit_ref.randomness.random_stream import random_words

# Random candidates are in no cache, and none depends on the result of another. So a few target
# pixels take each step together: all candidates are drawn, then prefetched from memory, then
# bounded, and the one in twelve that the bound does not reject is evaluated.
# plain_random_search.py does the same pixel by pixel.
PIXELS_A_BATCH = 16


@lru_cache
def _make_kernel(patch_width, channels, moments_a_patch, mean_channels):
    radius = patch_width // 2
    metric = make_fast_metric(patch_width, channels, moments_a_patch, mean_channels)
    may_improve, improve_proposal = metric.may_improve, metric.improve_proposal

    @njit(forceinline=True)
    def draw(candidates, centre_y, centre_x, source_height, source_width, stream, pixel):
        words = random_words(stream, pixel, search_draw(0))
        for k in range(candidates.shape[0]):
            if k > 0 and search_draw(k) != search_draw(k - 1):
                words = random_words(stream, pixel, search_draw(k))
            word_y, word_x = search_words(words, k)
            candidates[k, 0], candidates[k, 1] = random_candidate(
                word_y, word_x, centre_y, centre_x, search_radius(k),
                radius, source_height, source_width,
            )  # fmt: skip

    @kernel(patch_width, channels, moments_a_patch, mean_channels)
    def random_search_kernel(
        textures,
        omega_sums,
        occurrence_weight,
        nnf,
        delta,
        new_nnf,
        new_delta,
        stream,
        all_candidates,
        all_promising,
        all_counts,
    ):
        height, width = delta.shape
        source_height, source_width = omega_sums.shape
        radii = all_candidates.shape[2]
        for y in prange(height):
            candidates, promising, counts = all_candidates[y], all_promising[y], all_counts[y]
            for first_x in range(0, width, PIXELS_A_BATCH):
                batch = min(PIXELS_A_BATCH, width - first_x)
                for i in range(batch):
                    x = first_x + i
                    if nnf[y, x, 0] < 0:
                        continue
                    draw(
                        candidates[i], nnf[y, x, 0], nnf[y, x, 1],
                        source_height, source_width, stream, y * width + x,
                    )  # fmt: skip
                for i in range(batch):
                    if nnf[y, first_x + i, 0] < 0:
                        continue
                    for k in range(radii):
                        place = np.int64(candidates[i, k, 0]) * source_width + candidates[i, k, 1]
                        prefetch(omega_sums, place)
                        for line in range(0, moments_a_patch, LINE_MOMENTS):
                            prefetch(textures.source_moments, place * moments_a_patch + line)
                for i in range(batch):
                    x = first_x + i
                    counts[i] = 0
                    if nnf[y, x, 0] < 0:
                        continue
                    phi = delta[y, x] + penalization(
                        omega_sums, occurrence_weight, nnf[y, x, 0], nnf[y, x, 1]
                    )
                    for k in range(radii):
                        promising[i, counts[i]] = k
                        counts[i] += may_improve(
                            textures, omega_sums, occurrence_weight, y, x,
                            candidates[i, k, 0], candidates[i, k, 1], phi,
                        )  # fmt: skip
                for i in range(batch):
                    x = first_x + i
                    best_y, best_x = np.int64(nnf[y, x, 0]), np.int64(nnf[y, x, 1])
                    best_delta = delta[y, x]
                    if counts[i]:
                        best_phi = best_delta + penalization(
                            omega_sums, occurrence_weight, best_y, best_x
                        )
                        for n in range(counts[i]):
                            k = promising[i, n]
                            best_y, best_x, best_delta, best_phi = improve_proposal(
                                textures, omega_sums, occurrence_weight, y, x,
                                candidates[i, k, 0], candidates[i, k, 1],
                                best_y, best_x, best_delta, best_phi,
                            )  # fmt: skip
                    new_nnf[y, x, 0], new_nnf[y, x, 1] = best_y, best_x
                    new_delta[y, x] = best_delta

    return random_search_kernel


def random_search(
    textures: Textures,
    omega_sums: NDArray[np.int32],
    occurrence_weight: int,
    patch_width: int,
    nnf: NDArray[np.int32],
    delta: NDArray[np.int64],
    new_nnf: NDArray[np.int32],
    new_delta: NDArray[np.int64],
    stream: FourWords,
    side: int | None = None,
) -> None:
    """Offer every target patch random candidates at radius 1, 2, 4, ...

    The squares are centred on the assignment that the pass begins with; their radius doubles up to
    half of ``side``. Ω does not change during the pass.

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
    stream : tuple of 4 uint32
        From :func:`stylit_ref.randomness.random_stream.random_stream`.
    side : int, optional
        By default the larger side of the target, as in the thesis' kernel.
    """
    run = _make_kernel(*vector_sizes(textures, patch_width))
    height = delta.shape[0]
    radii = number_of_radii(side or max(delta.shape))
    candidates = np.empty((height, PIXELS_A_BATCH, radii, 2), np.int32)
    promising = np.empty((height, PIXELS_A_BATCH, radii), np.int32)
    counts = np.empty((height, PIXELS_A_BATCH), np.int32)
    run(
        textures, omega_sums, occurrence_weight, nnf, delta, new_nnf, new_delta, stream,
        candidates, promising, counts,
    )  # fmt: skip
