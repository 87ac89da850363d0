"""The sizes that the code of the metric is compiled for."""

from typing import NamedTuple

import numpy as np

from gpu_cuda.metric.patch_ssd import WORD_CHANNELS


class MetricConstants(NamedTuple):
    """What the code of the metric is compiled for.

    Attributes
    ----------
    patch_width : int
    channels : int
        Packed channels of a pixel, a multiple of 16.
    weighted_channels : int
        Number of channels without those of weight 0 at the end.
    mean_channels : int
        Number of channels at the start whose means a guide map may use; 0 without a guide map.
    """

    patch_width: int
    channels: int
    weighted_channels: int
    mean_channels: int

    @classmethod
    def of(cls, textures, patch_width):
        """The sizes of a level's textures."""
        weighted_channels = 2 * (1 + int(np.flatnonzero(textures.pair_weights)[-1]))
        return cls(patch_width, textures.source.shape[2], weighted_channels, textures.mean_channels)

    @classmethod
    def of_sizes(cls, sizes, with_map=False):
        """The sizes of kernels that are compiled without any textures.

        Parameters
        ----------
        sizes : gpu_cuda.host.argument_types.Sizes
        with_map : bool
            Whether there is a guide map.
        """
        weighted_channels = sizes.guide_channels + sizes.style_channels + sizes.style_channels % 2
        mean_channels = sizes.guide_channels if with_map else 0
        return cls(sizes.patch_width, sizes.channels, weighted_channels, mean_channels)

    @property
    def radius(self):
        """Patch radius."""
        return self.patch_width // 2

    @property
    def pixel_words(self):
        """Words of a packed pixel."""
        return self.channels // WORD_CHANNELS

    @property
    def weighted_words(self):
        """Words of a pixel that are read."""
        return -(-self.weighted_channels // WORD_CHANNELS)
