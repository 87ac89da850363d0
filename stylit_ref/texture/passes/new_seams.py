"""What every edge would cost if a cut crossed it: M between the new patch and the old side."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined, subroutine
from stylit_ref.texture.formulae.seam_cost import seam_cost
from stylit_ref.texture.passes.context import Context


@inlined
def _limited_cost(here, after_here, there, before_there, eta, exponent, halved, limit):
    cost = seam_cost(here, after_here, there, before_there, eta, exponent) >> halved
    return cost if cost < limit else limit


@subroutine
def new_seams(
    colours: NDArray[np.int32],
    stride: int,
    source: int,
    half_width: NDArray[np.int32],
    context: Context,
    eta: int,
    exponent: int,
    halved: int,
    limit: int,
    new_x: NDArray[np.int32],
    new_y: NDArray[np.int32],
) -> None:
    """Fill (n * n,) int32 arrays with the costs of all edges of a window.

    ``source`` is o_e, the address of the patch's centre. Of an edge's two pixels, the one nearer to
    the centre is taken to be in the patch. Costs are halved ``halved`` times, then cut off at the
    limit.
    """
    side = half_width.size
    centre = side // 2
    here, beside_x, beside_y = context.here, context.beside_x, context.beside_y
    # Slices and plain indices: with others the compiler finds no vector instructions.
    for j in range(1, side - 1):
        reach = half_width[j]
        middle = j * side + centre
        a = source + (j - centre) * stride
        new, before_new = colours[a - reach + 1 : a + 1], colours[a - reach : a]
        old, after_old = here[middle - reach : middle], beside_x[middle - reach : middle]
        costs = new_x[middle - reach : middle]
        for i in range(reach):
            costs[i] = _limited_cost(
                old[i], after_old[i], new[i], before_new[i], eta, exponent, halved, limit
            )
        new, after_new = colours[a : a + reach + 1], colours[a + 1 : a + reach + 2]
        old, before_old = (
            here[middle + 1 : middle + reach + 2],
            beside_x[middle + 1 : middle + reach + 2],
        )
        costs = new_x[middle : middle + reach + 1]
        for i in range(reach + 1):
            costs[i] = _limited_cost(
                new[i], after_new[i], old[i], before_old[i], eta, exponent, halved, limit
            )
        first, width = middle - reach, 2 * reach + 1
        costs = new_y[first : first + width]
        a -= reach
        if j < centre:
            new, before_new = colours[a + stride : a + stride + width], colours[a : a + width]
            old, after_old = here[first : first + width], beside_y[first : first + width]
            for i in range(width):
                costs[i] = _limited_cost(
                    old[i], after_old[i], new[i], before_new[i], eta, exponent, halved, limit
                )
        else:
            first += side
            new, after_new = colours[a : a + width], colours[a + stride : a + stride + width]
            old, before_old = here[first : first + width], beside_y[first : first + width]
            for i in range(width):
                costs[i] = _limited_cost(
                    new[i], after_new[i], old[i], before_old[i], eta, exponent, halved, limit
                )
