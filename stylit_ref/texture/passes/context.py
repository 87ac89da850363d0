"""What lies under a patch before it is placed: the old side of every possible cut."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined, subroutine
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
        end = j * side + centre + reach + 1
        column = (x - reach) % width
        inward_y = stride if j < centre else -stride
        while place < end:  # up to the last column of S at a time
            run = min(end - place, width - column)
            window, stretch = slice(place, place + run), slice(column, column + run)
            left = min(max(j * side + centre - place, 0), run)
            _read_colours(
                addresses[row, stretch], colours, left, inward_y, context.here[window],
                context.beside_x[window], context.beside_y[window],
            )  # fmt: skip
            cost_x, cost_y = seams_x[row, stretch], seams_y[row, stretch]
            costs, locked = context.seams[window], context.locked[window]
            for i in range(run):
                costs[i] = cost_x[i] + cost_y[i]
                total += np.int64(cost_x[i]) + cost_y[i]
            for i in range(run):
                kept = lock[row, column + i]
                if exemplar >= 0:
                    label = labels[row, column + i]
                    if label and label != exemplar + 1:
                        kept |= LOCKED
                locked[i] = kept
                free += not kept & LOCKED
            place += run
            column = 0
    return total, free


@inlined
def _read_colours(shown, colours, left, inward_y, here, beside_x, beside_y):
    for i in range(shown.size):
        a = shown[i]
        here[i] = colours[a]
        beside_x[i] = colours[a + 1] if i < left else colours[a - 1]
        beside_y[i] = colours[a + inward_y]
