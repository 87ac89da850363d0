"""The next coarser level of an image: 2x2 boxes, so that no level is shifted (equation 3 is)."""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.vector_pixel import make_halve_pixels, pixels_at_once
from stylit_ref.realtime.passes.border import extend_row
from stylit_ref.realtime.passes.image import Image


@cache
def make_halve(lanes: int) -> Callable[..., None]:
    """Build ``halve(fine, coarse)`` for pixels of so many bytes; the border is filled too."""
    halve_pixels, at_once = make_halve_pixels(lanes), pixels_at_once(lanes)

    @kernel(lanes, nogil=True)
    def halve(fine: Image, coarse: Image) -> None:
        for index in prange(coarse.height):
            y = np.int64(index)
            upper = ((2 * y + fine.border) * fine.stride + fine.border) * lanes
            lower = upper + fine.stride * lanes
            start = ((y + coarse.border) * coarse.stride + coarse.border) * lanes
            for x in range(0, coarse.width * lanes, at_once * lanes):
                halve_pixels(coarse.values, start + x, fine.values, upper + 2 * x, lower + 2 * x)
            extend_row(coarse, y, np.int64(lanes))

    return halve


@kernel(nogil=True)
def mark_labels(labels: NDArray[np.uint8], is_there: NDArray[np.bool_]) -> None:
    """Mark in (256,) ``is_there`` which labels there are."""
    for y in prange(labels.shape[0]):
        last = -1
        for x in range(np.uint64(labels.shape[1])):
            label = np.int64(labels[y, x])
            if label != last:  # neighbours mostly have the same, and a comparison is faster
                is_there[label] = True
                last = label


@kernel(parallel=False, nogil=True)
def decimate_labels(
    labels: NDArray[np.uint8], level: int, step: int, out: NDArray[np.int16]
) -> None:
    """Every ``step``-th label of a level. Labels are picked, not averaged.

    One thread is enough for so few, and takes half as long to compile.
    """
    height, width = out.shape
    apart = np.uint64(step << level)
    for a in range(np.uint64(height)):
        for b in range(np.uint64(width)):
            out[a, b] = labels[a * apart, b * apart]


@kernel(parallel=False, nogil=True)
def free_lost_labels(labels: NDArray[np.int16], is_there: NDArray[np.bool_]) -> None:
    """Free the entries whose label no centre of the source has at this level; none is free yet."""
    height, width = labels.shape
    for a in range(np.uint64(height)):
        for b in range(np.uint64(width)):
            if not is_there[np.uint64(labels[a, b])]:
                labels[a, b] = -1
