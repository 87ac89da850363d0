"""Voting: target pixels from the source patches that cover them (thesis 2.3, Kernel_Vote)."""

import numpy as np
from numba import njit, prange

from stylit_ref.formulae.candidates import clamp


@njit(parallel=True)
def vote(source, target, nnf, patch_width, style_channel, style_channels):
    """Average the votes for every pixel of the target's style.

    A pixel at ``(y, x)`` hears the patches centred at ``(y + dy, x + dx)`` that lie in
    the target and have an assignment Q; each votes for the source pixel
    ``Q - (dy, dx)``. Means are rounded half up. The thesis divides by w² everywhere;
    near the border fewer patches cover a pixel and the mean is over those.

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
    """
    height, width = nnf.shape[:2]
    radius = patch_width // 2
    for padded_y in prange(target.shape[0]):
        totals = np.zeros(style_channels, np.int64)
        y = clamp(padded_y - radius, 0, height - 1)
        for padded_x in range(target.shape[1]):
            x = clamp(padded_x - radius, 0, width - 1)
            totals[:] = 0
            votes = 0
            for near_y in range(max(y - radius, 0), min(y + radius + 1, height)):
                for near_x in range(max(x - radius, 0), min(x + radius + 1, width)):
                    if nnf[near_y, near_x, 0] >= 0:
                        source_y = nnf[near_y, near_x, 0] - (near_y - y)
                        source_x = nnf[near_y, near_x, 1] - (near_x - x)
                        for c in range(style_channels):
                            totals[c] += source[source_y, source_x, style_channel + c]
                        votes += 1
            for c in range(style_channels):
                mean = (2 * totals[c] + votes) // (2 * votes) if votes else 0
                target[padded_y, padded_x, style_channel + c] = mean
