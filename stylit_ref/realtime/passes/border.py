"""The border of an image repeats its edge, so that patches and boxes need no clamping.

Parallel loops write to an image by functions alone: Numba does not see that an attribute of a tuple
is somebody's array, and drops what a loop itself writes there as dead code.
"""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.realtime.passes.image import Image


@inlined
def put_row(values: NDArray[np.uint8], start: int, line: NDArray[np.uint8], length: int) -> None:
    """Copy the beginning of a line; a loop, since slices take Numba long to compile."""
    for i in range(np.uint64(length)):
        values[np.uint64(start) + i] = line[i]


@njit
def _repeat_row(values: NDArray[np.uint8], start: int, to: int, length: int) -> None:
    for i in range(np.uint64(length)):
        values[np.uint64(to) + i] = values[np.uint64(start) + i]


@njit
def extend_row(image: Image, y: int, lanes: int) -> None:
    """Repeat the ends of row ``y``; and the whole row, if it is the first or the last.

    Numba compiles it once for every constant that is given as ``lanes``, so give ``np.int64``.
    """
    values = image.values
    length = image.stride * lanes
    border = image.border * lanes
    start = (y + image.border) * length
    end = start + length - border
    for beside in range(0, border, lanes):
        _repeat_row(values, start + border, start + beside, lanes)
        _repeat_row(values, end - lanes, end + beside, lanes)
    if y == 0:
        for k in range(1, image.border + 1):
            _repeat_row(values, start, start - k * length, length)
    if y == image.height - 1:
        for k in range(1, image.border + 1):
            _repeat_row(values, start, start + k * length, length)


@cache
def make_extend(lanes: int) -> Callable[..., None]:
    """Build ``extend(image)``, which fills the border."""

    @kernel(lanes, nogil=True)
    def extend(image: Image) -> None:
        for y in prange(image.height):
            extend_row(image, y, np.int64(lanes))

    return extend
