"""The guide map G of a level (Kernel_EvaluateMap, thesis 5.2.2)."""

from functools import lru_cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.formulae.guide_map import scaled_variance, variance_limit
from stylit_ref.machine.kernel import kernel


@lru_cache
def _make_kernel(patch_width):
    @kernel(patch_width)
    def guide_map_kernel(texture, sums, weights, limit, white):
        for y in prange(white.shape[0]):
            for x in range(white.shape[1]):
                variance = scaled_variance(texture, sums[y, x], weights, y, x, patch_width)
                white[y, x] = variance < limit

    return guide_map_kernel


def guide_map(
    texture: NDArray[np.uint8],
    sums: NDArray[np.uint16 | np.uint32],
    weights: NDArray[np.int64],
    patch_width: int,
    epsilon: float,
    white: NDArray[np.bool_],
) -> None:
    """Find the target patches whose guides vary by less than ε.

    Parameters
    ----------
    texture : (H_B + 2 radius, W_B + 2 radius, C) uint8
        B̄, its edge pixels repeated.
    sums : (H_B, W_B, n) uint16 or uint32
        Sums of its guides, from :func:`stylit_ref.passes.means`.
    weights : (C,) int64
    patch_width : int
    epsilon : float
        ε, in squared 8-bit steps.
    white : (H_B, W_B) bool
        Receives G.
    """
    limit = variance_limit(epsilon, patch_width)
    _make_kernel(patch_width)(texture, sums, weights, limit, white)
