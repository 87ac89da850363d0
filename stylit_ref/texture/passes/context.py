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
    here : (n * n,) int32
        E[a] with a = S[t].
    beside_x, beside_y : (n * n,) int32
        E[a ± δ], the neighbour in the exemplar that lies towards the centre of the patch, in x and
        in y: there the new side of an edge will be.
    seams : (n * n,) int32
        What the two edges of a place cost now.
    locked : (n * n,) uint8
        The lock; a pixel for another exemplar than that of the patch is locked, too.
    """

    here: NDArray[np.int32]
    beside_x: NDArray[np.int32]
    beside_y: NDArray[np.int32]
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
    exemplar: int,
    context: Context,
) -> tuple[int, int]:
    """Fill a context around the pixel (y, x) of S, for a patch of ``exemplar``; -1 for any.

    Returns
    -------
    total, free : int
        What its seams cost, and how many of its pixels are not locked.
    """
    addresses, seams_x, seams_y, lock, labels = texture[:5]
    height, width = addresses.shape
    side = half_width.size
    centre = side // 2
    total, free = np.int64(0), 0
    for j in range(side):
        row = (y + j - centre) % height
        # An edge y belongs to the row above it, which may be the wider one.
        reach = min(max(half_width[j], half_width[max(j - 1, 0)]) + MARGIN - 1, centre)
        place = j * side + centre - reach
        column = (x - reach) % width
        inward_y = stride if j < centre else -stride
        for i in range(-reach, reach + 1):
            a = addresses[row, column]
            context.here[place] = colours[a]
            context.beside_x[place] = colours[a + 1] if i < 0 else colours[a - 1]
            context.beside_y[place] = colours[a + inward_y]
            cost_x, cost_y = seams_x[row, column], seams_y[row, column]
            context.seams[place] = cost_x + cost_y
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
