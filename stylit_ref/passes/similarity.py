"""δ of the current assignments (thesis 2.1)."""

from functools import lru_cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.metric.fast_metric import make_fast_metric
from stylit_ref.metric.textures import Textures, vector_sizes


@lru_cache
def _make_kernel(patch_width, channels, moments_a_patch, mean_channels):
    assignment_delta = make_fast_metric(
        patch_width, channels, moments_a_patch, mean_channels
    ).assignment_delta

    @kernel(patch_width, channels, moments_a_patch, mean_channels)
    def similarity_kernel(textures, nnf, delta):
        for y in prange(delta.shape[0]):
            for x in range(delta.shape[1]):
                if nnf[y, x, 0] >= 0:
                    delta[y, x] = assignment_delta(textures, y, x, nnf[y, x, 0], nnf[y, x, 1])

    return similarity_kernel


def similarity(
    textures: Textures, patch_width: int, nnf: NDArray[np.int32], delta: NDArray[np.int64]
) -> None:
    """Evaluate δ of every assignment.

    Parameters
    ----------
    textures : Textures
    patch_width : int
    nnf : (H_B, W_B, 2) int32
        Negative where a mask leaves the pixel alone; δ is left as it is there.
    delta : (H_B, W_B) int64
        Receives δ in fixed point.
    """
    _make_kernel(*vector_sizes(textures, patch_width))(textures, nnf, delta)
