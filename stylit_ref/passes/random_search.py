"""Random search around each assignment (Kernel_RandomSearch, 3.3)."""

from functools import lru_cache

import numpy as np
from numba import njit, prange

from stylit_ref.formulae.bounded_metric import make_bounded_metric
from stylit_ref.formulae.candidates import random_candidate
from stylit_ref.formulae.prefetch import prefetch
from stylit_ref.formulae.random_stream import random_words

# Target pixels whose candidates are drawn, and asked for from memory, ahead of their turn:
# random candidates miss every cache, and none depends on how another fared.
AHEAD = 8


@lru_cache
def _make_kernel(patch_width, channels):
    radius = patch_width // 2
    _, improve_proposal = make_bounded_metric(patch_width, channels)

    @njit(forceinline=True)
    def draw_candidates(candidates, centre_y, centre_x, textures, omega_sums, stream, pixel):
        source_height, source_width = omega_sums.shape
        words = random_words(stream, pixel, 0)
        for k in range(candidates.shape[0]):
            if k > 0 and k % 2 == 0:
                words = random_words(stream, pixel, k // 2)
            word_y, word_x = (words[0], words[1]) if k % 2 == 0 else (words[2], words[3])
            y, x = random_candidate(
                word_y, word_x, centre_y, centre_x, 1 << k, radius, source_height, source_width
            )
            candidates[k, 0], candidates[k, 1] = y, x
            place = np.int64(y) * source_width + x
            prefetch(omega_sums, place)
            prefetch(textures.source_sums, place * channels)

    @njit(parallel=True, error_model="numpy")
    def kernel(textures, omega_sums, occurrence_weight, nnf, delta, new_nnf, new_delta, stream):
        height, width = delta.shape
        radii = 0
        while 1 << radii <= max(height, width) // 2:
            radii += 1
        for y in prange(height):
            candidates = np.empty((AHEAD, radii, 2), np.int32)
            for first_x in range(0, width, AHEAD):
                block = range(first_x, min(first_x + AHEAD, width))
                for x in block:
                    if nnf[y, x, 0] >= 0:
                        draw_candidates(
                            candidates[x - first_x], nnf[y, x, 0], nnf[y, x, 1],
                            textures, omega_sums, stream, y * width + x,
                        )  # fmt: skip
                for x in block:
                    best_y, best_x, best_delta = nnf[y, x, 0], nnf[y, x, 1], delta[y, x]
                    if best_y >= 0:
                        best_phi = best_delta + occurrence_weight * omega_sums[best_y, best_x]
                        for k in range(radii):
                            best_y, best_x, best_delta, best_phi = improve_proposal(
                                textures, omega_sums, occurrence_weight, y, x,
                                candidates[x - first_x, k, 0], candidates[x - first_x, k, 1],
                                best_y, best_x, best_delta, best_phi,
                            )  # fmt: skip
                    new_nnf[y, x, 0], new_nnf[y, x, 1] = best_y, best_x
                    new_delta[y, x] = best_delta

    return kernel


def random_search(
    textures, omega_sums, occurrence_weight, patch_width, nnf, delta, new_nnf, new_delta, stream
):
    """Offer every target patch random candidates at radius 1, 2, 4, ...

    The squares are centred on the assignment the pass began with and double up to
    half the larger side of the target, as in the thesis' kernel. Ω stays as it is
    during the pass.

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
        From :func:`stylit_ref.formulae.random_stream.random_stream`.
    """
    kernel = _make_kernel(patch_width, textures.source.shape[2])
    kernel(textures, omega_sums, occurrence_weight, nnf, delta, new_nnf, new_delta, stream)
