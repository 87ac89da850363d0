"""Find where each pixel's point lies in the views around, masked by face, and fetch from there."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.realtime.formulae.packed_nnf import column_of, packed, row_of
from stylit_ref.views.formulae.shift import shifted


@kernel()
def shift(
    motion: NDArray[np.float32],
    labels: NDArray[np.int32],
    beside: NDArray[np.int32],
    view_labels: NDArray[np.int32],
    views: NDArray[np.int64],
    places: NDArray[np.int32],
) -> None:
    """Follow the motion of every pixel into K views; mask where they show another face.

    Parameters
    ----------
    motion : (K, H, W, 2) float32
        (x, y) in pixels.
    labels : (H, W) int32
        The face of every pixel, -1 for the sky.
    beside : (H, W, 2) int32
        (y, x) of the pixel whose face and motion each pixel takes: itself, or that past the
        silhouette that it lies beside.
    view_labels : (N, H, W) int32
        The faces of the grid's views, those beside silhouettes taken too.
    views : (K,) int64
        Which of them.
    places : (K, H, W) int32
        Written: the pixel in each view, y << 16 | x; its complement, which is negative, where it is
        masked. A place outside of the picture is masked, and held at the edge.
    """
    count, height, width = places.shape
    for line in prange(height):
        y = np.int64(line)
        for k in range(count):
            view = np.uint64(views[k])
            for x in range(width):
                near_y, near_x = np.uint64(beside[y, x, 0]), np.uint64(beside[y, x, 1])
                dx = np.float64(motion[k, near_y, near_x, 0])
                dy = np.float64(motion[k, near_y, near_x, 1])
                # Whatever is farther away than the whole picture, or no number, is outside.
                is_near = abs(dx) <= width and abs(dy) <= height
                row, column = y, x
                if is_near:
                    row, column = shifted(y, dy, 0), shifted(x, dx, 0)
                inner_y = min(max(row, 0), height - 1)
                inner_x = min(max(column, 0), width - 1)
                is_inside = is_near and row == inner_y and column == inner_x
                place = packed(inner_y, inner_x)
                if (
                    is_inside
                    and view_labels[view, np.uint64(inner_y), np.uint64(inner_x)]
                    == labels[near_y, near_x]
                ):
                    places[k, y, x] = place
                else:
                    places[k, y, x] = ~place


@kernel()
def fetch(
    nnfs: NDArray[np.int32],
    views: NDArray[np.int64],
    places: NDArray[np.int32],
    candidates: NDArray[np.int32],
    nnf: NDArray[np.int32],
) -> None:
    """Shift the NNFs of K views, and choose (equation 3.3).

    The first view counts that is not masked; the first of all, where all are.

    Parameters
    ----------
    nnfs : (N, H, W) int32
        Packed entries of the grid's views.
    views : (K,) int64
        Which of them, in the order in which they count: the closest first.
    places : (K, H, W) int32
        As of :func:`shift`.
    candidates : (K, H, W) int32
        Written: the shifted NNFs, -1 where they are masked.
    nnf : (H, W) int32
        Written: the chosen entries.
    """
    count, height, width = places.shape
    for y in prange(height):
        for x in range(width):
            chosen = -1
            for k in range(count):
                place, entry = places[k, y, x], -1
                if place >= 0:
                    entry = nnfs[views[k], row_of(place), column_of(place)]
                candidates[k, y, x] = entry
                if chosen < 0:
                    chosen = entry
            if chosen < 0:
                place = ~places[0, y, x]
                chosen = nnfs[views[0], row_of(place), column_of(place)]
            nnf[y, x] = chosen
