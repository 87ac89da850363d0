"""Random search around each assignment (Kernel_RandomSearch, 3.3)."""

from functools import lru_cache

import numpy as np
from numba import njit, prange

from stylit_ref.formulae.bounded_metric import make_bounded_metric
from stylit_ref.formulae.candidates import random_candidate
from stylit_ref.formulae.random_stream import random_words


@lru_cache
def _make_kernel(patch_width, channels):
    radius = patch_width // 2
    _, improve_proposal = make_bounded_metric(patch_width, channels)

    @njit(parallel=True, error_model="numpy")
    def kernel(textures, omega_sums, occurrence_weight, nnf, delta, new_nnf, new_delta, stream):
        height, width = delta.shape
        source_height, source_width = omega_sums.shape
        largest = max(height, width) // 2
        for y in prange(height):
            for x in range(width):
                best_y, best_x, best_delta = nnf[y, x, 0], nnf[y, x, 1], delta[y, x]
                best_phi = np.int64(0)
                search_radius = largest + 1
                if best_y >= 0:
                    best_phi = best_delta + occurrence_weight * omega_sums[best_y, best_x]
                    search_radius = 1
                centre_y, centre_x = best_y, best_x
                draw = 0
                while search_radius <= largest:
                    words = random_words(stream, y * width + x, draw)
                    for word_y, word_x in ((words[0], words[1]), (words[2], words[3])):
                        if search_radius <= largest:
                            candidate_y, candidate_x = random_candidate(
                                word_y, word_x, centre_y, centre_x, search_radius,
                                radius, source_height, source_width,
                            )  # fmt: skip
                            best_y, best_x, best_delta, best_phi = improve_proposal(
                                textures, omega_sums, occurrence_weight, y, x,
                                candidate_y, candidate_x, best_y, best_x, best_delta, best_phi,
                            )  # fmt: skip
                        search_radius *= 2
                    draw += 1
                new_nnf[y, x, 0], new_nnf[y, x, 1], new_delta[y, x] = best_y, best_x, best_delta

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
