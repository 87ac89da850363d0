r"""Compare φ without evaluating most of it: three exact shortcuts.

:mod:`stylit_ref.formulae.improve_assignment` evaluates λρ and δ of both patches in full. Here
a candidate is dropped as soon as a part of its φ proves that the whole is not below the best φ so
far. All numbers are exact integers, so the decisions are the same
(``tests/passes/test_proposals.py`` compares the two).

1. W(Q), Ω summed over the patch, is kept for every patch (one read in place of 25).
2. λρ(Q) alone is compared before any pixel is read.
3. The moments of the patches give a lower bound of δ (:mod:`stylit_ref.metric.lower_bound`), which
   reads a cache line or two in place of ten and more. It pays for random candidates, which are
   not in any cache: it rejects eleven in twelve. Propagated candidates are in the caches, since
   their neighbours have just read them, and are seldom much worse; for them the bound costs more
   than it saves.
"""

from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numba import njit

from stylit_ref.formulae.improve_assignment import make_improve_proposal
from stylit_ref.formulae.patch_penalization import penalization
from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.vector_ssd import make_weighted_ssd
from stylit_ref.metric.guide_map_metric import make_guide_map_delta
from stylit_ref.metric.lower_bound import BOUND_SCALE


@lru_cache
def make_delta_bound(moments_a_patch: int) -> Callable[..., int]:
    """Compile the lower bound of δ for patches with this number of moments.

    Returns
    -------
    callable
        ``(textures, y, x, source_y, source_x) -> int64``: ``BOUND_SCALE`` times a lower bound of
        δ.
    """
    moments_ssd = make_weighted_ssd(1, 1, moments_a_patch, element_bits=16)

    @inlined
    def delta_bound(textures, y, x, source_y, source_x):
        return moments_ssd(
            textures.target_moments,
            (y * np.int64(textures.target_moments.shape[1]) + x) * moments_a_patch,
            np.int64(0),
            textures.source_moments,
            (source_y * np.int64(textures.source_moments.shape[1]) + source_x) * moments_a_patch,
            np.int64(0),
            textures.moment_weights,
        )

    return delta_bound


class FastMetric(NamedTuple):
    """The compiled metric.

    Attributes
    ----------
    assignment_delta : callable
        ``(textures, y, x, source_y, source_x) -> int64``, equal to
        :func:`stylit_ref.formulae.patch_similarity.delta`; for patches that are white on a guide
        map, to :func:`stylit_ref.formulae.guide_map.delta_by_means`.
    may_improve : callable
        ``(textures, omega_sums, occurrence_weight, y, x, candidate_y, candidate_x,
        best_phi) -> bool``: False if λρ, alone or with the bound of δ, proves that the
        candidate's φ is not below ``best_phi``.
    improve_proposal : callable
        Made by :func:`stylit_ref.formulae.improve_assignment.make_improve_proposal`; its
        ``metric`` is the textures.
    """

    assignment_delta: Callable[..., int]
    may_improve: Callable[..., bool]
    improve_proposal: Callable[..., tuple[int, int, int, int]]


@lru_cache
def make_fast_metric(
    patch_width: int, channels: int, moments_a_patch: int, mean_channels: int
) -> FastMetric:
    """Compile the metric for the sizes of :func:`stylit_ref.metric.textures.vector_sizes`.

    Returns
    -------
    FastMetric
    """
    radius = patch_width // 2
    patch_ssd = make_weighted_ssd(patch_width, patch_width, channels, element_bits=8)
    delta_bound = make_delta_bound(moments_a_patch)

    @inlined
    def patch_delta(textures, y, x, source_y, source_x):
        source_stride = np.int64(textures.source.shape[1]) * channels
        target_stride = np.int64(textures.target.shape[1]) * channels
        return patch_ssd(
            textures.target,
            y * target_stride + x * channels,
            target_stride,
            textures.source,
            (source_y - radius) * source_stride + (source_x - radius) * channels,
            source_stride,
            textures.pair_weights,
        )

    assignment_delta = patch_delta
    if mean_channels:
        assignment_delta = make_guide_map_delta(patch_width, channels, mean_channels, patch_delta)

    @njit(inline="always")
    def delta_below(textures, y, x, source_y, source_x, limit):
        """The whole δ: stopping at a limit does not pay for vector code."""
        return assignment_delta(textures, y, x, source_y, source_x)

    @inlined
    def may_improve(
        textures, omega_sums, occurrence_weight, y, x, candidate_y, candidate_x, best_phi
    ):
        room = best_phi - penalization(omega_sums, occurrence_weight, candidate_y, candidate_x)
        return delta_bound(textures, y, x, candidate_y, candidate_x) < room * BOUND_SCALE

    improve_proposal = make_improve_proposal(inlined, delta_below)
    return FastMetric(assignment_delta, may_improve, improve_proposal)
