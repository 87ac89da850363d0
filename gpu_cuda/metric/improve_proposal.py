"""The choice between two assignments while Ω stays as it is: ImproveAssignment (thesis 3.2)."""

from functools import lru_cache

import numpy as np
from numba import njit

from gpu_cuda.metric.patch_ssd import make_patch_ssd
from stylit_ref.formulae import improve_assignment
from stylit_ref.formulae.guide_map import guides_by_means

NO_LIMIT = np.iinfo(np.int64).max


@lru_cache
def make_assignment_delta(constants):
    """Compile δ; with a guide map, the δ of thesis 5.2.2.

    Parameters
    ----------
    constants : gpu_cuda.metric.constants.MetricConstants

    Returns
    -------
    callable
        ``(metric, patch, y, x, source_y, source_x, limit) -> int64``: equal to
        :func:`stylit_ref.formulae.patch_similarity.delta` or
        :func:`stylit_ref.formulae.guide_map.delta_by_means` if that is below ``limit``, otherwise
        any number of at least ``limit``. ``metric`` is Ā and its width, weights, G, M_B and M_A of
        :func:`gpu_cuda.metric.textures.metric_arrays`; ``patch`` is the target patch as returned by
        :mod:`gpu_cuda.metric.target_patches`.
    """
    patch_width, _, weighted_channels, mean_channels = constants
    pixel_words, radius = constants.pixel_words, constants.radius
    patch_ssd = make_patch_ssd(patch_width, weighted_channels, 0)
    style_ssd = make_patch_ssd(patch_width, weighted_channels, mean_channels)

    @njit
    def assignment_delta(metric, patch, y, x, source_y, source_x, limit):
        source, source_width, weights, guide_map, target_sums, source_sums = metric
        patches, first, pixel, row = patch
        source_first = ((source_y - radius) * source_width + source_x - radius) * pixel_words
        source_row = source_width * pixel_words
        if mean_channels and guide_map[y, x]:
            guides = guides_by_means(
                weights, target_sums, source_sums, mean_channels, patch_width,
                y, x, source_y, source_x,
            )  # fmt: skip
            if guides >= limit:
                return guides
            return guides + style_ssd(
                patches, first, pixel, row,
                source, source_first, pixel_words, source_row, weights, limit - guides,
            )  # fmt: skip
        return patch_ssd(
            patches, first, pixel, row,
            source, source_first, pixel_words, source_row, weights, limit,
        )  # fmt: skip

    return assignment_delta


@lru_cache
def make_improve_proposal(constants):
    """Compile the choice; parameters as above.

    Returns
    -------
    callable
        As that of :func:`stylit_ref.formulae.improve_assignment.make_improve_proposal`, with the
        pair of ``metric`` and ``patch`` above as its ``metric``.
    """
    assignment_delta = make_assignment_delta(constants)

    @njit
    def delta_below(metric_and_patch, y, x, source_y, source_x, limit):
        metric, patch = metric_and_patch
        return assignment_delta(metric, patch, y, x, source_y, source_x, limit)

    return improve_assignment.make_improve_proposal(njit, delta_below)
