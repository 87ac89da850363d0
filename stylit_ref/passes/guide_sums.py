"""Sums of the guides over every patch, in place of means (Kernel_EvaluateMeans, thesis 5.2.2)."""

from functools import lru_cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.formulae.guide_map import patch_sum
from stylit_ref.machine.kernel import kernel


@lru_cache
def _make_kernel(patch_width):
    @kernel(patch_width)
    def means_kernel(texture, sums, first):
        for y in prange(texture.shape[0] - patch_width + 1):
            for x in range(texture.shape[1] - patch_width + 1):
                for c in range(sums.shape[2]):
                    sums[first + y, first + x, c] = patch_sum(texture, y, x, c, patch_width)

    return means_kernel


def means(
    texture: NDArray[np.uint8], sums: NDArray[np.uint16 | np.uint32], patch_width: int, first: int
) -> None:
    """Sum the guide channels over every patch that lies in a texture.

    The thesis (Evaluate_Means) and the ports use the name "means". The pass gives sums, w² times
    the means, since these are exact.

    Parameters
    ----------
    texture : (H, W, C) uint8
    sums : (H', W', n) uint16 or uint32
        ``sums[first + y, first + x]`` receives the sums of the patch whose first pixel is
        ``texture[y, x]``, for the first n packed channels. ``first`` is ``radius`` for the
        source and 0 for the target, as for :func:`stylit_ref.passes.patch_moments`.
    patch_width, first : int
    """
    _make_kernel(patch_width)(texture, sums, first)
