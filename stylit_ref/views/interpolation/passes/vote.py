"""Voting from shifted NNFs: the simple mean, fast enough for a moving view (3.3.2)."""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.realtime.formulae.packed_nnf import column_of, row_of
from stylit_ref.views.interpolation.formulae.mean import (
    PAIR,
    mean_of_votes,
    reciprocal_of,
)


@kernel()
def find_corners(
    nnf: NDArray[np.int32], stride: int, radius: int, corners: NDArray[np.int32]
) -> None:
    """Find the upper left pixel of every patch.

    Parameters
    ----------
    nnf : (H, W) int32
        Packed entries, whose patches lie within the style.
    stride : int
        Pixels of a row of the style.
    radius : int
        Of the patches.
    corners : (H, W) int32
        Written: the pixel's number, row by row.
    """
    for y in prange(nnf.shape[0]):
        for x in range(nnf.shape[1]):
            entry = nnf[y, x]
            corners[y, x] = (row_of(entry) - radius) * stride + column_of(entry) - radius


@inlined
def _mean_pixel(even, odd, count, reciprocal):
    low, high = np.uint64(0xFFFF), np.uint64(16)
    even, odd = np.uint64(even), np.uint64(odd)
    return np.uint32(
        mean_of_votes(even & low, count, reciprocal)
        | mean_of_votes(odd & low, count, reciprocal) << np.uint64(8)
        | mean_of_votes(even >> high, count, reciprocal) << np.uint64(16)
        | mean_of_votes(odd >> high, count, reciprocal) << np.uint64(24)
    )


@cache
def make_vote(width: int) -> Callable[..., None]:
    """Build ``vote`` for patches of ``width`` x ``width`` pixels, at most 15.

    The patches over a pixel vote for it, those near the picture's edge too, where they are fewer;
    means are rounded half up. The pass is called with

    - ``corners``, (H, W) int32, of :func:`find_corners`;
    - ``style``, (n,) uint32: the style's pixels, row by row, and ``stride``, how many a row has;
    - ``picture``, (rows, columns) uint32, of which the pixels from ``border`` on are written.
    """
    radius = width // 2

    @inlined
    def add_row(corners, style, first, even, odd):
        """Add the votes of a row of patches, away from its ends: a loop of vector instructions."""
        for x in range(radius, corners.shape[0] - radius):
            evens, odds = even[np.uint64(x)], odd[np.uint64(x)]
            for k in range(width):
                corner = np.uint32(corners[np.uint64(x + k - radius)])
                word = style[np.uint64(corner) + np.uint64(first + width - 1 - k)]
                evens += word & np.uint32(PAIR)
                odds += (word >> np.uint32(8)) & np.uint32(PAIR)
            even[np.uint64(x)], odd[np.uint64(x)] = evens, odds

    @inlined
    def add_end(corners, style, first, even, odd, begin, end):
        """Add those near an end of the row, where the picture holds fewer patches."""
        columns = corners.shape[0]
        for x in range(begin, end):
            for k in range(max(radius - x, 0), min(columns - x + radius, width)):
                word = style[corners[x + k - radius] + first + width - 1 - k]
                even[x] += word & np.uint32(PAIR)
                odd[x] += (word >> np.uint32(8)) & np.uint32(PAIR)

    @kernel(width, nogil=True)
    def vote(
        corners: NDArray[np.int32],
        style: NDArray[np.uint32],
        stride: int,
        picture: NDArray[np.uint32],
        border: int,
    ) -> None:
        height, columns = corners.shape
        left, right = min(radius, columns), max(columns - radius, radius)
        for line in prange(height):
            y = np.int64(line)
            even, odd = np.zeros(columns, np.uint32), np.zeros(columns, np.uint32)
            above, below = max(y - radius, 0), min(y + radius, height - 1)
            for a in range(above, below + 1):
                first = (radius + y - a) * stride
                add_row(corners[a], style, first, even, odd)
                add_end(corners[a], style, first, even, odd, 0, left)
                add_end(corners[a], style, first, even, odd, right, columns)
            out, rows = picture[y + border], below - above + 1
            count = np.uint64(rows * width)
            reciprocal = np.uint64(reciprocal_of(count))
            for x in range(radius, columns - radius):
                out[np.uint64(x + border)] = _mean_pixel(
                    even[np.uint64(x)], odd[np.uint64(x)], count, reciprocal
                )
            for end in range(left + columns - right):
                x = end if end < left else end - left + right
                across = min(x + radius, columns - 1) - max(x - radius, 0) + 1
                count = np.uint64(rows * across)
                out[x + border] = _mean_pixel(even[x], odd[x], count, reciprocal_of(count))

    return vote
