"""Where the points that land on the pixels of a place lie in the views around it."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel


@kernel()
def follow(
    winners: NDArray[np.int32],
    moved: NDArray[np.float32],
    ways: NDArray[np.float32],
    shown: NDArray[np.bool_],
    order: NDArray[np.int64],
    landed: NDArray[np.bool_],
    motion: NDArray[np.float32],
) -> None:
    """Find the motion of pixels that no view before has told.

    Parameters
    ----------
    winners : (H, W, 2) int32
        (y, x) of the pixel of a view that lands on each pixel, -1 for none.
    moved : (H, W, 2) float32
        (x, y) from the view's pixels to the place.
    ways : (N, H, W, 2) float32
        From the view's pixels to other views.
    shown : (N, H, W) bool
        Whether these show the view's points.
    order : (K,) int64
        The number of each view around, among those.
    landed : (H, W) bool
        Pixels that have been told; more become so.
    motion : (K, H, W, 2) float32
        Written for those: from the place to the views around, infinite where a view does not show
        the point.
    """
    height, width = landed.shape
    for y in prange(height):
        for x in range(width):
            row, column = winners[y, x, 0], winners[y, x, 1]
            if row < 0 or landed[y, x]:
                continue
            landed[y, x] = True
            for k in range(order.shape[0]):
                other = order[k]
                for c in range(2):
                    way = ways[other, row, column, c] - moved[row, column, c]
                    motion[k, y, x, c] = way if shown[other, row, column] else np.inf
