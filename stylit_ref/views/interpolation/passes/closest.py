"""The pixel of some that is closest to each pixel."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel

_STRIP = 32
"""Columns that are read side by side."""


@kernel()
def find_closest(
    known: NDArray[np.bool_], rows: NDArray[np.int32], places: NDArray[np.int32]
) -> None:
    """Find the known pixel that is closest to each pixel, by exact distances.

    Of several as close the one farthest to the left counts, then the upper one. What is not known
    is little, and what is closest is not far: so columns are searched one by one, outwards.

    Parameters
    ----------
    known : (H, W) bool
    rows : (H, W) int32
        Written: the row of the known pixel that is closest in the same column, -1 for none.
    places : (H, W, 2) int32
        Written: (y, x); the pixel itself where nothing is known.
    """
    height, width = known.shape
    for strip in prange((width + _STRIP - 1) // _STRIP):
        left = np.int64(strip) * _STRIP
        right = min(left + _STRIP, width)
        for y in range(height):
            for x in range(left, right):
                above = rows[y - 1, x] if y > 0 else -1
                rows[y, x] = y if known[y, x] else above
        for y in range(height - 2, -1, -1):
            for x in range(left, right):
                above, below = rows[y, x], rows[y + 1, x]
                # Below a gap stands what ends it, or again what is above the gap, or nothing.
                if below > y and (above < 0 or below - y < y - above):
                    rows[y, x] = below
    for line in prange(height):
        y = np.int64(line)
        for x in range(width):
            places[y, x, 0], places[y, x, 1] = y, x
            if known[y, x]:
                continue
            closest = height * height + width * width
            for away in range(width):
                if away * away > closest:
                    break
                for column in (x - away, x + away):
                    if not 0 <= column < width or rows[y, column] < 0:
                        continue
                    row = rows[y, column]
                    distance = (row - y) * (row - y) + away * away
                    # Columns to the left come ever farther left, those to the right never.
                    if distance < closest or (distance == closest and column < x):
                        closest = distance
                        places[y, x, 0], places[y, x, 1] = row, column
