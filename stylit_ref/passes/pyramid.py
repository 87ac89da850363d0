"""Image pyramid and the step from one level to the next (thesis 2.3, 3.4).

Each level is made from the next finer one. An odd last row or column has no 2 x 2 block of its own
and is left out.
"""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.formulae.candidates import upsampled_assignment
from stylit_ref.formulae.rounding import block_mean
from stylit_ref.machine.kernel import kernel


@kernel()
def _average_blocks(image, half):
    for y in prange(half.shape[0]):
        for x in range(half.shape[1]):
            for c in range(half.shape[2]):
                half[y, x, c] = block_mean(image, y, x, c)


def downsample(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Halve an image: means of 2 x 2 pixels, rounded half up.

    Parameters
    ----------
    image : (H, W, C) uint8

    Returns
    -------
    (H // 2, W // 2, C) uint8
    """
    height, width, channels = image.shape
    half = np.empty((height // 2, width // 2, channels), np.uint8)
    _average_blocks(image, half)
    return half


@kernel()
def upsample_nnf(
    coarse_nnf: NDArray[np.int32],
    nnf: NDArray[np.int32],
    patch_width: int,
    source_height: int,
    source_width: int,
) -> None:
    """Carry assignments to the next finer level.

    Parameters
    ----------
    coarse_nnf : (H, W, 2) int32
    nnf : (H_B, W_B, 2) int32
        Overwritten, except where it is negative (pixels a mask leaves alone).
    patch_width, source_height, source_width : int
        The finer level's source.
    """
    radius = patch_width // 2
    for y in prange(nnf.shape[0]):
        for x in range(nnf.shape[1]):
            if nnf[y, x, 0] >= 0:
                nnf[y, x, 0], nnf[y, x, 1] = upsampled_assignment(
                    coarse_nnf, y, x, radius, source_height, source_width
                )
