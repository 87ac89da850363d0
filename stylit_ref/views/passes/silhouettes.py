"""Find what lies beside something nearer."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.views.formulae.silhouette import is_nearer, is_step


@kernel()
def find_rims(inverse: NDArray[np.float64], rims: NDArray[np.bool_]) -> None:
    """Find the pixels beside which depth steps back.

    Parameters
    ----------
    inverse : (H, W) float64
        Inverse depths.
    rims : (H, W) bool
        Written.
    """
    height, width = inverse.shape
    for y in prange(height):
        for x in range(width):
            rims[y, x] = False
            for turn in range(4):
                down = (turn - 1) * (1 - turn % 2)  # -1, 0, 1, 0
                right = (turn - 2) * (turn % 2)  # 0, -1, 0, 1
                row, column = y + down, x + right
                if 0 <= row < height and 0 <= column < width:
                    near, far = inverse[y, x], inverse[row, column]
                    # Outside of the picture the plane goes on.
                    before, behind = 2 * near - far, 2 * far - near
                    if 0 <= y - down < height and 0 <= x - right < width:
                        before = inverse[y - down, x - right]
                    if 0 <= row + down < height and 0 <= column + right < width:
                        behind = inverse[row + down, column + right]
                    rims[y, x] |= is_step(before, near, far, behind)


@kernel()
def take_nearer(
    inverse: NDArray[np.float64],
    rims: NDArray[np.bool_],
    is_close: NDArray[np.bool_],
    reach: int,
    places: NDArray[np.int32],
) -> None:
    """Find the rim that each pixel lies beside, the closest that is nearer, and look past it.

    Of several as close the nearest counts, then the first, row by row. Vectors of a rim may be
    blended with those of what lies behind, by the filter of pixels. So the pixel behind it counts,
    seen from outside, unless the thing has ended there.

    Parameters
    ----------
    inverse, rims
        As of :func:`find_rims`.
    is_close : (H, W) bool
        False where no rim within reach is nearer; such pixels are passed over.
    reach : int
        In pixels.
    places : (H, W, 2) int32
        Written: (y, x) of the pixel past the rim, or of the pixel itself.
    """
    height, width = inverse.shape
    for y in prange(height):
        for x in range(width):
            places[y, x, 0], places[y, x, 1] = y, x
            if not is_close[y, x]:
                continue
            closest, nearest = reach * reach + 1, np.inf
            for row in range(max(y - reach, 0), min(y + reach + 1, height)):
                if (row - y) * (row - y) > closest:
                    continue
                for column in range(max(x - reach, 0), min(x + reach + 1, width)):
                    if rims[row, column]:
                        away = (row - y) * (row - y) + (column - x) * (column - x)
                        there = inverse[row, column]
                        wins = away < closest or (away == closest and there > nearest)
                        if wins and is_nearer(there, inverse[y, x]):
                            closest, nearest = away, there
                            places[y, x, 0], places[y, x, 1] = row, column
            if closest <= reach * reach:
                rim_y, rim_x = places[y, x, 0], places[y, x, 1]
                row = rim_y + (rim_y > y) - (rim_y < y)
                column = rim_x + (rim_x > x) - (rim_x < x)
                is_inside = 0 <= row < height and 0 <= column < width
                if is_inside and not is_nearer(inverse[rim_y, rim_x], inverse[row, column]):
                    places[y, x, 0], places[y, x, 1] = row, column
