"""Voting: target pixels from the source patches that cover them (thesis 2.3, Kernel_Vote)."""

from functools import lru_cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.formulae.rounding import rounded_mean
from stylit_ref.formulae.voting import (
    discard_farthest,
    distance_from_mean,
    voted_pixel,
    votes_kept,
)
from stylit_ref.machine.kernel import kernel


@lru_cache
def _make_kernel(patch_width, style_channels):
    radius = patch_width // 2

    @kernel(patch_width, style_channels)
    def vote_kernel(source, target, nnf, style_channel):
        height, width = nnf.shape[:2]
        for y in prange(height):
            for x in range(width):
                inside = radius <= y < height - radius and radius <= x < width - radius
                # One scalar for each channel stays in a register; the compiler removes
                # those that the style does not have.
                total_0 = total_1 = total_2 = total_3 = votes = 0
                for dy in range(-radius, radius + 1):
                    for dx in range(-radius, radius + 1):
                        near_y, near_x = y + dy, x + dx
                        if not inside and not (0 <= near_y < height and 0 <= near_x < width):
                            continue
                        if nnf[near_y, near_x, 0] < 0:
                            continue
                        voted_y, voted_x = voted_pixel(nnf, y, x, near_y, near_x)
                        source_y, source_x = np.uint64(voted_y), np.uint64(voted_x)
                        total_0 += source[source_y, source_x, style_channel]
                        if style_channels > 1:
                            total_1 += source[source_y, source_x, style_channel + 1]
                        if style_channels > 2:
                            total_2 += source[source_y, source_x, style_channel + 2]
                        if style_channels > 3:
                            total_3 += source[source_y, source_x, style_channel + 3]
                        votes += 1
                totals = (total_0, total_1, total_2, total_3)
                for c in range(style_channels):
                    mean = rounded_mean(totals[c], votes)
                    target[radius + y, radius + x, style_channel + c] = mean

    return vote_kernel


@lru_cache
def _make_robust_kernel(patch_width, style_channels):
    """Compile the mean without the votes farthest from it (Hauptfleisch 2020, 2.4.1)."""
    radius = patch_width // 2

    @kernel(patch_width, style_channels)
    def robust_vote_kernel(source, target, nnf, style_channel, outliers, all_values, all_distances):
        height, width = nnf.shape[:2]
        for y in prange(height):
            values, distances = all_values[y], all_distances[y]
            for x in range(width):
                votes = 0
                for near_y in range(max(y - radius, 0), min(y + radius + 1, height)):
                    for near_x in range(max(x - radius, 0), min(x + radius + 1, width)):
                        if nnf[near_y, near_x, 0] < 0:
                            continue
                        source_y, source_x = voted_pixel(nnf, y, x, near_y, near_x)
                        for c in range(style_channels):
                            values[votes, c] = source[source_y, source_x, style_channel + c]
                        votes += 1
                for n in range(votes):
                    distances[n] = 0
                for c in range(style_channels):
                    total = 0
                    for n in range(votes):
                        total += values[n, c]
                    for n in range(votes):
                        distances[n] += distance_from_mean(values[n, c], total, votes)
                kept = votes_kept(votes, outliers)
                discard_farthest(distances, votes, kept)
                for c in range(style_channels):
                    total = 0
                    for n in range(votes):
                        if distances[n] >= 0:
                            total += values[n, c]
                    mean = rounded_mean(total, kept)
                    target[radius + y, radius + x, style_channel + c] = mean

    return robust_vote_kernel


def vote(
    source: NDArray[np.uint8],
    target: NDArray[np.uint8],
    nnf: NDArray[np.int32],
    patch_width: int,
    style_channel: int,
    style_channels: int,
    outliers: int = 0,
) -> None:
    """Average the votes for every pixel of the target's style.

    The patches centred at ``(y + dy, x + dx)`` vote for the pixel ``(y, x)``, if they lie in the
    target and have an assignment Q; the vote is the source pixel ``Q - (dy, dx)``. Means are
    rounded half up. The thesis divides by w² everywhere; near the border fewer patches cover a
    pixel, and here the mean is over those.

    Parameters
    ----------
    source : (H_A, W_A, C) uint8
    target : (H_B + 2 radius, W_B + 2 radius, C) uint8
        Its style channels are overwritten, the repeated edge pixels included. A pixel
        that no assigned patch covers (deep inside a mask) becomes 0.
    nnf : (H_B, W_B, 2) int32
    patch_width : int
    style_channel, style_channels : int
        First style channel in a packed pixel and their number.
    outliers : int
        t, the number of votes that do not count: those farthest from the mean of all. Of equally
        far votes, those of patches further up, then further left, are left out first. One vote
        always counts.
    """
    if outliers:
        run = _make_robust_kernel(patch_width, style_channels)
        rows, votes = nnf.shape[0], patch_width**2
        values = np.empty((rows, votes, style_channels), np.int64)
        distances = np.empty((rows, votes), np.int64)
        run(source, target, nnf, style_channel, outliers, values, distances)
    else:
        _make_kernel(patch_width, style_channels)(source, target, nnf, style_channel)
    radius = patch_width // 2
    style = target[:, :, style_channel : style_channel + style_channels]
    style[:radius], style[-radius:] = style[radius], style[-radius - 1]
    style[:, :radius] = style[:, radius, None]
    style[:, -radius:] = style[:, -radius - 1, None]
