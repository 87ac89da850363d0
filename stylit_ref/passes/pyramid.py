"""Image pyramid and the step from one level to the next (thesis 2.3, 3.4).

The thesis samples with bilinear interpolation and gives no source code; at a factor
of two that is the mean of 2 x 2 pixels, here rounded half up. A level is made from the
one above it. A last odd row or column has no 2 x 2 block of its own and is left out.
"""

import numpy as np
from numba import prange

from stylit_ref.formulae.candidates import clamp
from stylit_ref.kernel import kernel


@kernel()
def _average_blocks(image, half):
    for y in prange(half.shape[0]):
        for x in range(half.shape[1]):
            for c in range(half.shape[2]):
                total = (
                    np.int32(image[2 * y, 2 * x, c])
                    + np.int32(image[2 * y, 2 * x + 1, c])
                    + np.int32(image[2 * y + 1, 2 * x, c])
                    + np.int32(image[2 * y + 1, 2 * x + 1, c])
                )
                half[y, x, c] = (total + 2) // 4


def downsample(image):
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
def upsample_nnf(coarse_nnf, nnf, patch_width, source_height, source_width):
    """Carry assignments to the next finer level.

    A target pixel takes twice its parent's coordinates plus its own offset from
    twice the parent, clamped to the centres the source has.

    Parameters
    ----------
    coarse_nnf : (H, W, 2) int32
    nnf : (H_B, W_B, 2) int32
        Overwritten, except where it is negative (pixels a mask leaves alone).
    patch_width, source_height, source_width : int
        The finer level's source.
    """
    radius = patch_width // 2
    coarse_height, coarse_width = coarse_nnf.shape[:2]
    for y in prange(nnf.shape[0]):
        for x in range(nnf.shape[1]):
            if nnf[y, x, 0] >= 0:
                parent_y, parent_x = min(y // 2, coarse_height - 1), min(x // 2, coarse_width - 1)
                fine_y = 2 * coarse_nnf[parent_y, parent_x, 0] + (y - 2 * parent_y)
                fine_x = 2 * coarse_nnf[parent_y, parent_x, 1] + (x - 2 * parent_x)
                nnf[y, x, 0] = clamp(fine_y, radius, source_height - 1 - radius)
                nnf[y, x, 1] = clamp(fine_x, radius, source_width - 1 - radius)
