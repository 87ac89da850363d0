"""What the kernels of the search need of the textures."""

from typing import NamedTuple

import numpy as np

from gpu_cuda.host.device import BLOCK, launch
from gpu_cuda.host.memory import kept_on_device
from gpu_cuda.patch_ssd import WORD_CHANNELS


class MetricConstants(NamedTuple):
    """What the code of the metric is compiled for.

    Attributes
    ----------
    patch_width : int
    channels : int
        Packed channels of a pixel, a multiple of 16.
    weighted_channels : int
        Without those at the end that weigh nothing.
    mean_channels : int
        The first of them, which means may stand for; 0 without a guide map.
    """

    patch_width: int
    channels: int
    weighted_channels: int
    mean_channels: int

    @classmethod
    def of(cls, textures, patch_width):
        """Those of a level's textures."""
        mean_channels = 0 if textures.guide_map is None else textures.source_sums.shape[2]
        weighted_channels = 2 * (1 + int(np.flatnonzero(textures.pair_weights)[-1]))
        return cls(patch_width, textures.source.shape[2], weighted_channels, mean_channels)

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


def metric_arrays(textures):
    """Ā, B̄, weights, G, M_B and M_A, as kernels take them.

    The textures are flat arrays of words. Without a guide map nothing reads the last three: Ā
    stands in for them.
    """
    means = textures.guide_map, textures.target_sums, textures.source_sums
    if textures.guide_map is None:
        source = textures.source
        sums = source.view(np.uint16)
        means = source.reshape(1, source.size).view(np.bool_), sums, sums
    weights = kept_on_device(textures.pair_weights)
    return words(textures.source), words(textures.target), weights, *means


def words(texture):
    """A packed texture of the device as a flat array of uint32."""
    return texture.reshape(texture.size).view(np.uint32)


def launch_search(
    make_kernel, textures, omega_sums, occurrence_weight, patch_width,
    nnf, delta, new_nnf, new_delta, *parameters, block=BLOCK, shared=False,
):  # fmt: skip
    """Run Kernel_Propagation or Kernel_RandomSearch; ``parameters`` are its last arguments."""
    launch(
        make_kernel(MetricConstants.of(textures, patch_width), block, shared), delta.shape,
        *metric_arrays(textures), omega_sums, occurrence_weight,
        nnf, delta, new_nnf, new_delta, *parameters, block=block,
    )  # fmt: skip
