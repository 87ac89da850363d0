"""What a patch hides where not all pixels may change, and where a guide has a say.

Locked pixels keep what they show, and a patch is written around them. So a seam between two of them
can be neither hidden nor made: a cut may cross it for nothing. A seam between a locked pixel and
one that changes stays a seam, with the patch on its other side: the patch hides the old cost and
pays the new one, wherever its cut runs. (The paper says only that copying from holes can be
prevented; ending the cut at locked pixels instead leaves specks that no patch reaches.)
"""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined, subroutine
from stylit_ref.texture.formulae.guide_cost import guide_cost
from stylit_ref.texture.formulae.seam_cost import edge_cost
from stylit_ref.texture.passes.context import Context
from stylit_ref.texture.passes.layout import FREE_BELOW, FREE_RIGHT, LOCKED, Settings, Texture


@inlined
def is_free_x(locked: NDArray[np.uint8], place: int) -> bool:
    """Whether a cut crosses the edge between a place and the one to its right for nothing."""
    return locked[place] & locked[place + 1] & LOCKED > 0 or locked[place] & FREE_RIGHT > 0


@inlined
def is_free_y(locked: NDArray[np.uint8], place: int, side: int) -> bool:
    """The same of the edge below a place, in a window of ``side`` places a row."""
    return locked[place] & locked[place + side] & LOCKED > 0 or locked[place] & FREE_BELOW > 0


@subroutine
def free_locked_edges(
    half_width: NDArray[np.int32],
    context: Context,
    new_x: NDArray[np.int32],
    new_y: NDArray[np.int32],
) -> None:
    """Let cuts cross edges between locked pixels for nothing, and those that are free."""
    side = half_width.size
    locked = context.locked
    for j in range(1, side - 1):
        reach = half_width[j]
        middle = j * side + side // 2
        for place in range(middle - reach, middle + reach + 1):
            if is_free_x(locked, place):
                new_x[place] = 0
            if is_free_y(locked, place, side):
                new_y[place] = 0


@subroutine
def hidden_beside_locked(
    texture: Texture,
    colours: NDArray[np.int32],
    settings: Settings,
    source: int,
    y: int,
    x: int,
    half_width: NDArray[np.int32],
    context: Context,
    hidden: NDArray[np.int32],
) -> None:
    """What covering each pixel of a window saves in seams, less what it pays to locked pixels."""
    addresses, seams_x, seams_y = texture[:3]
    stride, eta, exponent = settings.stride, settings.eta, settings.exponent
    height, width = seams_x.shape
    side = half_width.size
    centre = side // 2
    locked = context.locked
    hidden[:] = 0
    for j in range(1, side - 1):
        row = (y + j - centre) % height
        below = (row + 1) % height
        reach = half_width[j]
        for i in range(centre - reach, centre + reach + 1):
            place = j * side + i
            column = (x + i - centre) % width
            a = addresses[row, column]
            new = source + (j - centre) * stride + i - centre
            saved = np.int64(0)
            if not is_free_x(locked, place):
                saved += seams_x[row, column]
                if locked[place] & LOCKED:
                    saved -= edge_cost(colours, a, new + 1, 1, eta, exponent)
                elif locked[place + 1] & LOCKED:
                    b = addresses[row, (column + 1) % width]
                    saved -= edge_cost(colours, new, b, 1, eta, exponent)
            if not is_free_y(locked, place, side):
                saved += seams_y[row, column]
                if locked[place] & LOCKED:
                    saved -= edge_cost(colours, a, new + stride, stride, eta, exponent)
                elif locked[place + side] & LOCKED:
                    b = addresses[below, column]
                    saved -= edge_cost(colours, new, b, stride, eta, exponent)
            hidden[place] = saved


@subroutine
def hidden_by_guide(
    texture: Texture,
    guide_colours: NDArray[np.int32],
    settings: Settings,
    source: int,
    y: int,
    x: int,
    half_width: NDArray[np.int32],
    context: Context,
    hidden: NDArray[np.int32],
) -> None:
    """Add what covering each pixel saves in guide costs."""
    addresses, guide = texture.addresses, texture.guide
    stride, weight = settings.stride, settings.guide_weight
    height, width = addresses.shape
    side = half_width.size
    centre = side // 2
    for j in range(1, side - 1):
        row = (y + j - centre) % height
        reach = half_width[j]
        for i in range(centre - reach, centre + reach + 1):
            place = j * side + i
            if context.locked[place] & LOCKED:
                continue
            column = (x + i - centre) % width
            wanted = guide[row, column]
            new = source + (j - centre) * stride + i - centre
            saved = (
                np.int64(hidden[place])
                + guide_cost(guide_colours[addresses[row, column]], wanted, weight)
                - guide_cost(guide_colours[new], wanted, weight)
            )
            hidden[place] = saved


@subroutine
def magnitude(hidden: NDArray[np.int32]) -> int:
    """The sum of all absolute values; places outside the disc are 0."""
    total = np.int64(0)
    for place in range(hidden.size):
        total += abs(np.int64(hidden[place]))
    return total
