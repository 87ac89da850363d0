"""Carry the pixels of a frame along their motion, to invert it."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.views.formulae.vectors import ONE, differ, fixed


# Several pixels can land on one, so that rows can't run at once.
@kernel(parallel=False)
def splat(
    field: NDArray[np.float32],
    places: NDArray[np.int32],
    depth: NDArray[np.float32],
    winners: NDArray[np.int32],
) -> None:
    """Find which pixel lands on each pixel of the other frame.

    Of several the nearest wins, then the one that lands closest to the middle of the pixel, then
    the one that comes first, row by row.

    Parameters
    ----------
    field : (H, W, 2) float32
        (x, y) in pixels.
    places : (H, W, 2) int32
        Where each pixel lands: (y, x), or -1 for nowhere.
    depth : (H, W) float32
        All alike where it is not known; numbers, infinite where nothing is.
    winners : (H, W, 2) int32
        Written: (y, x) of the pixel that lands there, -1 for none.
    """
    height, width = depth.shape
    distances = np.empty((height, width), np.int64)
    winners[:] = -1
    for y in range(height):
        for x in range(width):
            row, column = places[y, x, 0], places[y, x, 1]
            if row >= 0:
                away_x = fixed(field[y, x, 0]) + (x - column) * ONE
                away_y = fixed(field[y, x, 1]) + (y - row) * ONE
                distance = away_x * away_x + away_y * away_y
                before_y, before_x = winners[row, column, 0], winners[row, column, 1]
                wins = before_y < 0
                if not wins:
                    other = depth[before_y, before_x]
                    wins = depth[y, x] < other or (
                        depth[y, x] == other and distance < distances[row, column]
                    )
                if wins:
                    winners[row, column, 0], winners[row, column, 1] = y, x
                    distances[row, column] = distance


@kernel(parallel=False)
def find_beaten(
    field: NDArray[np.float32],
    places: NDArray[np.int32],
    winners: NDArray[np.int32],
    beaten: NDArray[np.bool_],
    contested: NDArray[np.bool_],
) -> None:
    """Find pixels that land where a pixel with another motion wins.

    Parameters
    ----------
    field, places, winners
        As of :func:`splat`.
    beaten : (H, W) bool
        Written: whether the pixel has lost to one whose motion differs by more than a pixel.
    contested : (H, W) bool
        Written: whether such pixels meet on a pixel of the other frame.
    """
    contested[:] = False
    for y in range(beaten.shape[0]):
        for x in range(beaten.shape[1]):
            beaten[y, x] = False
            row, column = places[y, x, 0], places[y, x, 1]
            if row >= 0:
                top, left = winners[row, column, 0], winners[row, column, 1]
                beaten[y, x] = differ(
                    fixed(field[y, x, 0]),
                    fixed(field[y, x, 1]),
                    fixed(field[top, left, 0]),
                    fixed(field[top, left, 1]),
                )
                contested[row, column] |= beaten[y, x]
