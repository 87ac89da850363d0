"""Sums over patches, per channel: what the lower bound of δ reads."""

from functools import lru_cache

import numpy as np
from numba import njit, prange

from stylit_ref.formulae.bounded_metric import sum_width


@lru_cache
def _make_kernel(patch_width, first_channel, channels):
    """Widths and channels are constants, so that the innermost loops become vectors."""
    width = sum_width(patch_width)
    margin = patch_width // 2 - width // 2

    @njit(parallel=True)
    def kernel(texture, sums, first):
        centres_y = texture.shape[0] - patch_width + 1
        centres_x = texture.shape[1] - patch_width + 1
        for y in prange(centres_y):
            block = np.empty(channels, np.int16)
            columns = np.zeros((texture.shape[1], channels), np.int16)
            for dy in range(width):
                for x in range(texture.shape[1]):
                    for c in range(first_channel, channels):
                        columns[x, c] += np.int16(texture[y + margin + dy, x, c])
            for x in range(centres_x):
                block[:] = 0
                for dx in range(width):
                    for c in range(first_channel, channels):
                        block[c] += columns[x + margin + dx, c]
                for c in range(first_channel, channels):
                    sums[first + y, first + x, c] = block[c]

    return kernel


def patch_sums(texture, sums, patch_width, first, first_channel=0):
    """Sum every patch that lies in a texture, channel by channel.

    Parameters
    ----------
    texture : (H, W, C) uint8
    sums : (H', W', C) int16
        ``sums[first + y, first + x]`` receives the sum over the patch whose first
        pixel is ``texture[y, x]`` (over its central 11 x 11 pixels if it is wider):
        ``first`` is ``radius`` for the source, whose sums are indexed by patch centre,
        and 0 for the target, whose edge is repeated ``radius`` times.
    patch_width, first : int
    first_channel : int
        Channels below it are left as they are: guides do not change with votes.
    """
    _make_kernel(patch_width, first_channel, texture.shape[2])(texture, sums, first)
