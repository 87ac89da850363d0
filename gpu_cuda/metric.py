"""What the kernels of the search need of the textures."""

from functools import cache

import numpy as np
from numba import cuda

from gpu_cuda.device import BLOCK, launch


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


def launch_search(
    make_kernel, textures, omega_sums, occurrence_weight, patch_width,
    nnf, delta, new_nnf, new_delta, *parameters, block=BLOCK, shared=False,
):  # fmt: skip
    """Run Kernel_Propagation or Kernel_RandomSearch; ``parameters`` are its last arguments."""
    launch(
        make_kernel(*constants(textures, patch_width), block, shared), delta.shape,
        *metric_arrays(textures), omega_sums, occurrence_weight,
        nnf, delta, new_nnf, new_delta, *parameters, block=block,
    )  # fmt: skip


@cache
def _no_means():
    sums = cuda.to_device(np.zeros((1, 1, 1), np.uint16))
    return cuda.to_device(np.zeros((1, 1), np.bool_)), sums, sums
