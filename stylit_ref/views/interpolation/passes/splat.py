"""What a view shows, from the points of other views: each lands on a pixel."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.views.interpolation.formulae.transfer import projected


# Several points can land on one pixel, so that rows can't run at once.
@kernel(parallel=False)
def splat_points(
    points: NDArray[np.float32],
    labels: NDArray[np.int32],
    views: NDArray[np.int64],
    camera: NDArray[np.float64],
    slack: float,
    found: NDArray[np.int32],
    inverse: NDArray[np.float64],
) -> None:
    """Carry the points of K views to the pixels that they land on; the nearest wins.

    Of faces that meet, each has points that land on the pixels along their edge, and what lands
    beside the middle of a pixel is not what it shows. So a point counts as farther away the more it
    lands beside it: (1 / z) (1 - slack d²) decides, with d the distance in pixels. Of equals the
    one of the first view counts, then the first, row by row.

    Parameters
    ----------
    points : (N, H, W, 3) float32
        In the scene.
    labels : (N, H, W) int32
        -1 where nothing is.
    views : (K,) int64
        Which views.
    camera : (3, 4) float64
        The matrix of the view that is made.
    slack : float
        From 0, where depth alone decides, to 2.
    found : (H, W) int32
        Written: the labels, -1 where nothing lands.
    inverse : (H, W) float64
        Written: 1 / depth, 0 where nothing lands.
    """
    height, width = found.shape
    found[:], inverse[:] = -1, 0.0
    merits = np.zeros((height, width))
    for view in views:
        for y in range(height):
            for x in range(width):
                if labels[view, y, x] < 0:
                    continue
                across, down, near = projected(camera, points[view, y, x])
                # NaN and what is behind the camera are not inside.
                if -0.5 <= across < width - 0.5 and -0.5 <= down < height - 0.5:
                    row, column = int(np.floor(down + 0.5)), int(np.floor(across + 0.5))
                    away_x, away_y = across - column, down - row
                    merit = near * (1 - slack * (away_x * away_x + away_y * away_y))
                    if merit > merits[row, column]:
                        merits[row, column] = merit
                        inverse[row, column] = near
                        found[row, column] = labels[view, y, x]


@kernel()
def fill_holes(
    found: NDArray[np.int32],
    inverse: NDArray[np.float64],
    filled: NDArray[np.int32],
    filled_inverse: NDArray[np.float64],
) -> None:
    """Fill pixels on which nothing has landed, between others on both sides.

    A surface that is seen from closer by leaves gaps. Neighbours on the left and on the right come
    before those above and below. The farther one of the two counts: what comes into view lies
    behind.

    Parameters
    ----------
    found, inverse
        As of :func:`splat_points`.
    filled, filled_inverse
        Written: the same without gaps of a pixel.
    """
    height, width = found.shape
    for line in prange(height):
        y = np.int64(line)
        for x in range(width):
            filled[y, x], filled_inverse[y, x] = found[y, x], inverse[y, x]
            if found[y, x] >= 0:
                continue
            for down, right in ((0, 1), (1, 0)):
                if not (down <= y < height - down and right <= x < width - right):
                    continue
                if filled[y, x] >= 0:
                    continue
                one_y, one_x, other_y, other_x = y - down, x - right, y + down, x + right
                if found[one_y, one_x] < 0 or found[other_y, other_x] < 0:
                    continue
                if inverse[other_y, other_x] < inverse[one_y, one_x]:
                    one_y, one_x = other_y, other_x
                filled[y, x], filled_inverse[y, x] = found[one_y, one_x], inverse[one_y, one_x]
