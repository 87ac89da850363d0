"""The textures of one pyramid level, as the metric reads them."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Textures(NamedTuple):
    """Ā and B̄ of one pyramid level with their patches' moments.

    Only the method ``guide_map`` has the last four.

    Attributes
    ----------
    source : (H_A, W_A, C) uint8
    target : (H_B + 2 radius, W_B + 2 radius, C) uint8
        Edge pixels repeated ``radius`` times.
    source_moments : (H_A, W_A, m) int16
        Moments of the patch around each pixel; zero if the patch leaves the source. They fill
        whole cache lines, and the array begins at the start of one.
    target_moments : (H_B, W_B, m) int16
    weights : (C,) int64
        Fixed-point weight of each channel.
    pair_weights : (C / 2,) uint32
        The same, one for two neighbouring channels.
    moment_weights : (m / 2,) uint32
        Weights of two neighbouring moments in the bound.
    guide_map : (H_B, W_B) bool, optional
        G of thesis 5.2: True (white) where a patch's guides are compared by their means.
    source_sums, target_sums : (H_A, W_A, n) and (H_B, W_B, n) uint16 or uint32, optional
        M_A and M_B times w²: the sums of the guides over each patch, in packed channels.
    style_pair_weights : (C / 2,) uint32, optional
        ``pair_weights`` with 0 for the guides.
    """

    source: NDArray[np.uint8]
    target: NDArray[np.uint8]
    source_moments: NDArray[np.int16]
    target_moments: NDArray[np.int16]
    weights: NDArray[np.int64]
    pair_weights: NDArray[np.uint32]
    moment_weights: NDArray[np.uint32]
    guide_map: NDArray[np.bool_] | None = None
    source_sums: NDArray[np.uint16 | np.uint32] | None = None
    target_sums: NDArray[np.uint16 | np.uint32] | None = None
    style_pair_weights: NDArray[np.uint32] | None = None

    @property
    def mean_channels(self) -> int:
        """Number of packed guide channels with sums; 0 without a guide map."""
        return 0 if self.guide_map is None else self.source_sums.shape[2]


def vector_sizes(textures: Textures, patch_width: int) -> tuple[int, int, int, int]:
    """The sizes that the metric's vector code for the CPU is compiled for.

    Parameters
    ----------
    textures : Textures
    patch_width : int

    Returns
    -------
    tuple of 4 int
        Patch width, packed channels of a pixel, moments of a patch, and packed guide channels
        with sums.
    """
    channels, moments = textures.source.shape[2], textures.source_moments.shape[2]
    return patch_width, channels, moments, textures.mean_channels
