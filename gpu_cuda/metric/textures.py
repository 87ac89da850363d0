"""Textures as the kernels of the metric take them."""

import numpy as np

from gpu_cuda.host.memory import kept_on_device


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
