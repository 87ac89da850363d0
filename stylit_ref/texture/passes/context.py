"""What lies under a patch before it is placed: the old side of every possible cut."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import subroutine
from stylit_ref.texture.formulae.polar import MARGIN
from stylit_ref.texture.passes.layout import LOCKED, Texture


class Context(NamedTuple):
    """A window of S (:class:`stylit_ref.texture.formulae.polar.Polar`), row by row.

    Attributes
    ----------
    here, right, left, below, above : (n * n,) int32
        With a = S[t], the colours E[a], E[a + (0, 1)], E[a - (0, 1)], E[a + (1, 0)], E[a - (1, 0)].
    seams : (n * n,) int32
        What the two edges of a place cost now, each cut off at the limit.
    locked : (n * n,) uint8
        The lock; a pixel for another exemplar than that of the patch is locked, too.
    """

    here: NDArray[np.int32]
    right: NDArray[np.int32]
    left: NDArray[np.int32]
    below: NDArray[np.int32]
    above: NDArray[np.int32]
    seams: NDArray[np.int32]
    locked: NDArray[np.uint8]


@subroutine
def read_context(
    texture: Texture,
    colours: NDArray[np.int32],
    stride: int,
    y: int,
    x: int,
    half_width: NDArray[np.int32],
    limit: int,
    exemplar: int,
    context: Context,
) -> tuple[int, int]:
    """Fill a context around the pixel (y, x) of S, for a patch of ``exemplar``; -1 for any.

    Returns
    -------
    total, free : int
        What its seams cost, without a limit, and how many of its pixels are not locked.
    """
    addresses, seams_x, seams_y, lock, labels = texture[:5]
    height, width = addresses.shape
    side = half_width.size
    centre = side // 2
    total, free = np.int64(0), 0
    for j in range(side):
        row = (y + j - centre) % height
        reach = min(half_width[j] + MARGIN - 1, centre)
        place = j * side + centre - reach
        column = (x - reach) % width
        for _ in range(2 * reach + 1):
            a = addresses[row, column]
            context.here[place] = colours[a]
            context.right[place] = colours[a + 1]
            context.left[place] = colours[a - 1]
            context.below[place] = colours[a + stride]
            context.above[place] = colours[a - stride]
            cost_x, cost_y = seams_x[row, column], seams_y[row, column]
            context.seams[place] = min(cost_x, limit) + min(cost_y, limit)
            kept = lock[row, column]
            if exemplar >= 0 and labels[row, column] and labels[row, column] != exemplar + 1:
                kept |= LOCKED
            context.locked[place] = kept
            total += np.int64(cost_x) + cost_y
            free += not kept & LOCKED
            place += 1
            column += 1
            if column == width:
                column = 0
    return total, free
