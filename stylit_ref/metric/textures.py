"""The textures of one pyramid level, as the metric reads them."""

from typing import NamedTuple

import numpy as np


class Textures(NamedTuple):
    """Ā and B̄ of one pyramid level with their patches' moments.

    The last four are there for the method ``guide_map`` alone.

    Attributes
    ----------
    source : (H_A, W_A, C) uint8
    target : (H_B + 2 radius, W_B + 2 radius, C) uint8
        Edge pixels repeated ``radius`` times.
    source_moments : (H_A, W_A, m) int16
        Moments of the patch centred at each pixel (zero at centres whose patch leaves
        the source). Whole cache lines: the first of them starts one.
    target_moments : (H_B, W_B, m) int16
    weights : (C,) int64
        Fixed-point weight of each channel.
    pair_weights : (C / 2,) uint32
        The same, one for two neighbouring channels.
    moment_weights : (m / 2,) uint32
        Weights of two neighbouring moments in the bound.
    guide_map : (H_B, W_B) bool, optional
        G of thesis 5.2: True (white) where means stand for a patch's guides.
    source_sums, target_sums : (H_A, W_A, n) and (H_B, W_B, n) uint16 or uint32, optional
        M_A and M_B times w²: the guides' sums over each patch, in packed channels.
    style_pair_weights : (C / 2,) uint32, optional
        ``pair_weights`` without the guides'.
    """

    source: np.ndarray
    target: np.ndarray
    source_moments: np.ndarray
    target_moments: np.ndarray
    weights: np.ndarray
    pair_weights: np.ndarray
    moment_weights: np.ndarray
    guide_map: np.ndarray | None = None
    source_sums: np.ndarray | None = None
    target_sums: np.ndarray | None = None
    style_pair_weights: np.ndarray | None = None

    @property
    def mean_channels(self):
        """Packed guide channels that means may stand for: 0 without a guide map."""
        return 0 if self.guide_map is None else self.source_sums.shape[2]


def vector_sizes(textures, patch_width):
    """What the metric's vector code for the CPU is compiled for, as its factories take it.

    Parameters
    ----------
    textures : Textures
    patch_width : int

    Returns
    -------
    tuple of 4 int
        Patch width, packed channels of a pixel, moments of a patch, and the packed guide
        channels that means may stand for.
    """
    channels, moments = textures.source.shape[2], textures.source_moments.shape[2]
    return patch_width, channels, moments, textures.mean_channels
