"""Random search as the thesis writes its kernel (3.3): pixel by pixel, candidate by candidate.

:mod:`stylit_ref.passes.random_search` gives the same results faster. Here δ of every candidate is
evaluated in full, unless λρ alone exceeds the best φ, as in the thesis.

The two differ in the bound of δ, batches and prefetching. They share the draws, the choice, and δ
in vector code: δ in its simplest form is six times as slow, and a comparison of times would not
show what the bound saves. Their agreement does not test the code they share; the tests by brute
force do.
"""

from functools import lru_cache

import numpy as np
from numba import prange
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
from stylit_ref.metric.fast_metric import make_fast_metric
from stylit_ref.metric.textures import Textures, vector_sizes
from stylit_ref.randomness.philox import FourWords
from stylit_ref.randomness.random_stream import random_words


@lru_cache
def _make_kernel(patch_width, channels, moments_a_patch, mean_channels):
    radius = patch_width // 2
    improve_proposal = make_fast_metric(
        patch_width, channels, moments_a_patch, mean_channels
    ).improve_proposal

    @kernel(patch_width, channels, moments_a_patch, mean_channels)
    def plain_random_search_kernel(
        textures, omega_sums, occurrence_weight, nnf, delta, new_nnf, new_delta, stream, radii
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
                    for k in range(radii):
                        draw = random_words(stream, y * width + x, search_draw(k))
                        word_y, word_x = search_words(draw, k)
                        candidate_y, candidate_x = random_candidate(
                            word_y, word_x, nnf[y, x, 0], nnf[y, x, 1], search_radius(k),
                            radius, source_height, source_width,
                        )  # fmt: skip
                        best_y, best_x, best_delta, best_phi = improve_proposal(
                            textures, omega_sums, occurrence_weight, y, x,
                            candidate_y, candidate_x, best_y, best_x, best_delta, best_phi,
                        )  # fmt: skip
                new_nnf[y, x, 0], new_nnf[y, x, 1], new_delta[y, x] = best_y, best_x, best_delta

    return plain_random_search_kernel


def plain_random_search(
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
    """Parameters and results are those of :func:`stylit_ref.passes.random_search`."""
    run = _make_kernel(*vector_sizes(textures, patch_width))
    radii = number_of_radii(side or max(delta.shape))
    run(textures, omega_sums, occurrence_weight, nnf, delta, new_nnf, new_delta, stream, radii)
