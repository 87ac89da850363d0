"""Random search and its δ without the exact lower bound: what the bound saves, measured."""

from functools import lru_cache

from numba import prange

from stylit_ref import passes
from stylit_ref.formulae.candidates import random_candidate
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.replaced import replaced
from stylit_ref.metric.fast_metric import make_bounded_metric
from stylit_ref.metric.textures import metric_constants
from stylit_ref.randomness.random_stream import random_words


@lru_cache
def _make_kernel(patch_width, channels, lanes, mean_channels):
    radius = patch_width // 2
    _, _, improve_proposal = make_bounded_metric(patch_width, channels, lanes, mean_channels)

    @kernel(patch_width, channels, lanes, mean_channels)
    def unbounded_search_kernel(
        textures, omega_sums, occurrence_weight, nnf, delta, new_nnf, new_delta, stream
    ):
        height, width = delta.shape
        source_height, source_width = omega_sums.shape
        for y in prange(height):
            for x in range(width):
                best_y, best_x, best_delta = nnf[y, x, 0], nnf[y, x, 1], delta[y, x]
                if best_y >= 0:
                    best_phi = best_delta + occurrence_weight * omega_sums[best_y, best_x]
                    search_radius, k = 1, 0
                    while 2 * search_radius <= max(height, width):
                        words = random_words(stream, y * width + x, k // 2)
                        word_y, word_x = words[:2] if k % 2 == 0 else words[2:]
                        candidate_y, candidate_x = random_candidate(
                            word_y, word_x, nnf[y, x, 0], nnf[y, x, 1], search_radius,
                            radius, source_height, source_width,
                        )  # fmt: skip
                        best_y, best_x, best_delta, best_phi = improve_proposal(
                            textures, omega_sums, occurrence_weight, y, x,
                            candidate_y, candidate_x, best_y, best_x, best_delta, best_phi,
                        )  # fmt: skip
                        search_radius *= 2
                        k += 1
                new_nnf[y, x, 0], new_nnf[y, x, 1], new_delta[y, x] = best_y, best_x, best_delta

    return unbounded_search_kernel


def random_search(
    textures, omega_sums, occurrence_weight, patch_width, nnf, delta, new_nnf, new_delta, stream
):
    """As :func:`stylit_ref.passes.random_search`, every candidate's δ evaluated in full.

    Only where λρ alone exceeds the best φ it is not, as in the thesis.
    """
    run = _make_kernel(*metric_constants(textures, patch_width))
    run(textures, omega_sums, occurrence_weight, nnf, delta, new_nnf, new_delta, stream)


UNBOUNDED = replaced(passes, random_search=random_search)
"""The passes with this search in the place of theirs."""
