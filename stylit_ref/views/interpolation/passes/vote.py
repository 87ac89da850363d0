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
    WIDEST,
    mean_of_votes,
    reciprocal_of,
)

__all__ = ["WIDEST", "make_vote"]


@inlined
def _add_votes(entries, begin, end, shift, style, offset, stride, even, odd):
    """Add the votes of one place in the patches; a loop of vector instructions."""
    for x in range(begin, end):
        entry = entries[np.uint64(x + shift)]
        word = style[np.uint64(row_of(entry) * stride + column_of(entry) - offset)]
        even[np.uint64(x)] += word & np.uint32(PAIR)
        odd[np.uint64(x)] += (word >> np.uint32(8)) & np.uint32(PAIR)


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

    - ``nnf``, (H, W) int32: packed entries, whose patches lie within the style;
    - ``style``, (n,) uint32: the style's pixels, row by row, and ``stride``, how many a row has;
    - ``picture``, (rows, columns) uint32, of which the pixels from ``border`` on are written.
    """
    radius = width // 2

    @kernel(width, nogil=True)
    def vote(
        nnf: NDArray[np.int32],
        style: NDArray[np.uint32],
        stride: int,
        picture: NDArray[np.uint32],
        border: int,
    ) -> None:
        height, columns = nnf.shape
        for row in prange(height):
            y = np.int64(row)
            even, odd = np.zeros(columns, np.uint32), np.zeros(columns, np.uint32)
            above, below = max(y - radius, 0), min(y + radius, height - 1)
            for a in range(above, below + 1):
                entries = nnf[a]
                for shift in range(-radius, radius + 1):
                    begin, end = max(-shift, 0), min(columns - shift, columns)
                    offset = (a - y) * stride + shift
                    _add_votes(entries, begin, end, shift, style, offset, stride, even, odd)
            out, rows = picture[y + border], below - above + 1
            for x in range(min(radius, columns)):
                count = np.uint64(rows * (min(x + radius, columns - 1) + 1))
                out[x + border] = _mean_pixel(even[x], odd[x], count, reciprocal_of(count))
            count = np.uint64(rows * width)
            reciprocal = np.uint64(reciprocal_of(count))
            for x in range(radius, columns - radius):
                out[np.uint64(x + border)] = _mean_pixel(
                    even[np.uint64(x)], odd[np.uint64(x)], count, reciprocal
                )
            for x in range(max(columns - radius, radius), columns):
                count = np.uint64(rows * (columns - max(x - radius, 0)))
                out[x + border] = _mean_pixel(even[x], odd[x], count, reciprocal_of(count))

    return vote
