"""Where the pixels of a view move as it turns towards others."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.views.formulae.shift import shifted


@kernel()
def move(
    ways: NDArray[np.float32],
    views: NDArray[np.int64],
    shares: NDArray[np.float32],
    landed: NDArray[np.bool_],
    moved: NDArray[np.float32],
    places: NDArray[np.int32],
) -> None:
    """Sum up shares of the ways to other views, and follow them.

    Parameters
    ----------
    ways : (N, H, W, 2) float32
        From a view's pixels to other views, (x, y).
    views : (M,) int64
        Which of them, in the order in which they are added.
    shares : (M,) float32
    landed : (H, W) bool
        Pixels of the place that nothing more is asked of.
    moved : (H, W, 2) float32
        Written: from the view's pixels to the place.
    places : (H, W, 2) int32
        Written: the pixel, (y, x), that each leads to; -1 if it is outside, or one of those.
    """
    height, width = landed.shape
    for line in prange(height):
        y = np.int64(line)
        for x in range(width):
            for c in range(2):
                total = np.float32(0)
                for k in range(views.shape[0]):
                    total += shares[k] * ways[views[k], y, x, c]
                moved[y, x, c] = total
            places[y, x, 0] = places[y, x, 1] = -1
            dx, dy = np.float64(moved[y, x, 0]), np.float64(moved[y, x, 1])
            # Whatever is farther away than the whole picture, or no number, is outside.
            if abs(dx) <= width and abs(dy) <= height:
                row, column = shifted(y, dy, 0), shifted(x, dx, 0)
                if 0 <= row < height and 0 <= column < width and not landed[row, column]:
                    places[y, x, 0], places[y, x, 1] = row, column
