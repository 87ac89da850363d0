"""Shift a picture to a neighbouring frame, at any level (3.2.1, 3.2.2)."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.views.formulae.shift import representative, shifted


@kernel()
def shift_map(
    motion: NDArray[np.float32], visible: NDArray[np.bool_], depth: int, places: NDArray[np.int32]
) -> None:
    """Find where each pixel of a level lies in the other frame.

    Parameters
    ----------
    motion : (H, W, 2) float32
        (x, y) in pixels of the finest level, of this frame's pixels.
    visible : (H, W) bool
        False where the other frame does not show the pixel's point.
    depth : int
        How many levels are finer than this one.
    places : (H >> depth, W >> depth, 2) int32
        Written: (y, x) in the other frame's level, -1 where it does not show the point.
    """
    height, width = places.shape[:2]
    for y in prange(height):
        for x in range(width):
            places[y, x, 0] = places[y, x, 1] = -1
            j, i = representative(y, depth), representative(x, depth)
            dx, dy = np.float64(motion[j, i, 0]), np.float64(motion[j, i, 1])
            # Whatever is farther away than the whole frame, or no number at all, is outside.
            if visible[j, i] and abs(dx) <= motion.shape[1] and abs(dy) <= motion.shape[0]:
                row, column = shifted(y, dy, depth), shifted(x, dx, depth)
                if 0 <= row < height and 0 <= column < width:
                    places[y, x, 0], places[y, x, 1] = row, column


@kernel()
def shift_picture(
    picture: NDArray[np.uint8],
    places: NDArray[np.int32],
    own: NDArray[np.uint8],
    guide: NDArray[np.uint8],
) -> None:
    """Make G_c from the picture of a neighbour.

    Parameters
    ----------
    picture : (H, W, n) uint8
        The other frame's B'.
    places : (H, W, 2) int32
        From :func:`shift_map`.
    own : (H, W, n) uint8
        This frame's B'. It is taken where the other frame does not show the point, so that nothing
        pulls there.
    guide : (H, W, n) uint8
        Written: G_c.
    """
    for y in prange(places.shape[0]):
        for x in range(places.shape[1]):
            row, column = places[y, x, 0], places[y, x, 1]
            for c in range(own.shape[2]):
                guide[y, x, c] = own[y, x, c] if row < 0 else picture[row, column, c]
