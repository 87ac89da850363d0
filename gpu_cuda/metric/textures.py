"""Convert textures to the form that the kernels of the metric take."""

import numpy as np


def metric_arrays(textures):
    """Ā, B̄, weights, G, M_B and M_A, as kernels take them.

    The textures are flat arrays of words. Without a guide map the last three are never read; Ā then
    takes their places.
    """
    means = textures.guide_map, textures.target_sums, textures.source_sums
    if textures.guide_map is None:
        source = textures.source
        sums = source.view(np.uint16)
        means = source.reshape(1, source.size).view(np.bool_), sums, sums
    return words(textures.source), words(textures.target), textures.weights, *means


def words(texture):
    """A packed texture of the device as a flat array of uint32."""
    return texture.reshape(texture.size).view(np.uint32)
