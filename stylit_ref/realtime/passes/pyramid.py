"""The next coarser level of an image: 2x2 boxes, so that no level is shifted (equation 3 is)."""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.realtime.formulae.average import mean_of_four
from stylit_ref.realtime.passes.border import extend_row
from stylit_ref.realtime.passes.image import Image


@inlined
def _halve_row(upper, lower, out, width, lanes):
    for x in range(np.uint64(width)):
        for c in range(np.uint64(lanes)):
            left = np.uint64(2 * lanes) * x + c
            right = left + np.uint64(lanes)
            out[np.uint64(lanes) * x + c] = mean_of_four(
                upper[left], upper[right], lower[left], lower[right]
            )


@cache
def make_halve(lanes: int) -> Callable[..., None]:
    """Build ``halve(fine, coarse)`` for pixels of so many bytes; the border is filled too."""

    @kernel(lanes, nogil=True)
    def halve(fine: Image, coarse: Image) -> None:
        for index in prange(coarse.height):
            y = np.int64(index)
            row = ((2 * y + fine.border) * fine.stride + fine.border) * lanes
            upper = fine.values[row : row + 2 * coarse.width * lanes]
            row += fine.stride * lanes
            lower = fine.values[row : row + 2 * coarse.width * lanes]
            row = ((y + coarse.border) * coarse.stride + coarse.border) * lanes
            out = coarse.values[row : row + coarse.width * lanes]
            _halve_row(upper, lower, out, coarse.width, lanes)
            extend_row(coarse, y, lanes)

    return halve


@kernel(nogil=True)
def decimate_labels(
    labels: NDArray[np.uint8], level: int, step: int, out: NDArray[np.int16]
) -> None:
    """Every ``step``-th label of a level. Labels are picked, not averaged."""
    height, width = out.shape
    for a in prange(height):
        for b in range(width):
            out[a, b] = labels[(a * step) << level, (b * step) << level]


@kernel(nogil=True)
def free_lost_labels(labels: NDArray[np.int16], is_there: NDArray[np.bool_]) -> None:
    """Free the entries whose label no centre of the source has at this level."""
    height, width = labels.shape
    for a in prange(height):
        for b in range(width):
            if not is_there[labels[a, b]]:
                labels[a, b] = -1
