"""What the kernels of the search need of the textures."""

from functools import cache

import numpy as np
from numba import cuda


def constants(textures, patch_width):
    """What the search is compiled for: patch width, packed channels, channels with means."""
    mean_channels = 0 if textures.guide_map is None else textures.source_sums.shape[2]
    return patch_width, textures.source.shape[2], mean_channels


def metric_arrays(textures):
    """Ā, B̄, weights, G, M_B and M_A, as kernels take them; stand-ins without a guide map."""
    means = textures.guide_map, textures.target_sums, textures.source_sums
    if textures.guide_map is None:
        means = _no_means()
    return textures.source, textures.target, textures.weights, *means


@cache
def _no_means():
    sums = cuda.to_device(np.zeros((1, 1, 1), np.uint16))
    return cuda.to_device(np.zeros((1, 1), np.bool_)), sums, sums
