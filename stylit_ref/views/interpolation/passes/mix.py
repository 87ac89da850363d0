"""Mix pictures, by weights of the whole or of what is not masked (3.3.1)."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.realtime.formulae.packed_nnf import column_of, row_of
from stylit_ref.views.interpolation.formulae.weights import weighted_mean


@kernel()
def mix(pictures: NDArray[np.uint8], weights: NDArray[np.int64], mixed: NDArray[np.uint8]) -> None:
    """The weighted mean of K pictures: the linear blend of views, and the fade between frames.

    Parameters
    ----------
    pictures : (K, H, W, n) uint8
    weights : (K,) int64
        In units of 1/65536; their sum is not 0.
    mixed : (H, W, n) uint8
        Written; rounded half up.
    """
    whole = weights.sum()
    count, height, width, channels = pictures.shape
    for y in prange(height):
        for x in range(width):
            for c in range(channels):
                total = np.int64(0)
                for k in range(count):
                    total += weights[k] * np.int64(pictures[k, y, x, c])
                mixed[y, x, c] = weighted_mean(total, whole)


@kernel()
def mix_shifted(
    pictures: NDArray[np.uint8],
    views: NDArray[np.int64],
    places: NDArray[np.int32],
    weights: NDArray[np.int64],
    mixed: NDArray[np.uint8],
) -> None:
    """The weighted mean of those of K shifted pictures that are not masked.

    Where those weigh nothing the first of them counts, and where all are masked the first picture.

    Parameters
    ----------
    pictures : (N, H, W, n) uint8
        Of the grid's views.
    views : (K,) int64
        Which of them: the closest first.
    places : (K, H, W) int32
        Where each pixel lies in them, as of
        :func:`~stylit_ref.views.interpolation.passes.shift.shift`.
    weights : (K,) int64
        In units of 1/65536; that of the first may be all, which shifts one picture and fills what
        is masked from the others.
    mixed : (H, W, n) uint8
        Written; rounded half up.
    """
    count, height, width = places.shape
    for y in prange(height):
        for x in range(width):
            whole, first = np.int64(0), -1
            for k in range(count):
                if places[k, y, x] >= 0:
                    whole += weights[k]
                    if first < 0:
                        first = k
            for c in range(pictures.shape[3]):
                if whole > 0:
                    total = np.int64(0)
                    for k in range(count):
                        place = places[k, y, x]
                        if place >= 0 and weights[k] > 0:
                            value = pictures[views[k], row_of(place), column_of(place), c]
                            total += weights[k] * np.int64(value)
                    mixed[y, x, c] = weighted_mean(total, whole)
                else:
                    k = max(first, 0)
                    place = places[k, y, x]
                    if place < 0:
                        place = ~place
                    mixed[y, x, c] = pictures[views[k], row_of(place), column_of(place), c]
