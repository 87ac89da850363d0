"""Feature alignment along a cut (section 5): M_D, whose best closed path is D."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import subroutine
from stylit_ref.texture.formulae.deformation import address_at, position
from stylit_ref.texture.formulae.polar import BLOCKED, WEIGHT_BITS, Polar
from stylit_ref.texture.formulae.seam_cost import cost_beside, squared_distance
from stylit_ref.texture.passes.context import Context
from stylit_ref.texture.passes.layout import Settings
from stylit_ref.texture.passes.lock import is_free_x, is_free_y

_HALF = 1 << (WEIGHT_BITS - 1)


@subroutine
def alignment_costs(
    colours: NDArray[np.int32],
    settings: Settings,
    source: int,
    polar: Polar,
    path: NDArray[np.int32],
    context: Context,
    halved: int,
    line: NDArray[np.int32],
    costs: NDArray[np.int32],
    steps: NDArray[np.int32],
) -> None:
    """M_D for every row and every shift of at most D_max rows.

    The colour half a pixel inside the cut in row y + k is put in row y, beside the old pixel just
    outside. A change of the shift from one row to the next costs ``settings.penalty``. Every
    crossing weighs the arc of its row by the direction of its border, as H does; what the cut
    crosses for nothing costs nothing.

    Parameters
    ----------
    colours : (n,) int32
    settings : Settings
    source : int
        The address of the patch's centre.
    polar : Polar
    path : (H,) int32
        C.
    context : Context
    halved : int
        How often costs are halved.
    line : (9, H + 2 D_max) int32
        Room for the colours along the cut, of their four neighbours, and the squared distances to
        these.
    costs, steps : (H, 2 D_max + 3) int32
        Receive M_D, with a blocked column on either side, and the running sums of the penalty: the
        tables of a cut with a largest jump of 1.
    """
    stride, plane, fractions = settings.stride, settings.plane, settings.fractions
    eta, exponent, limit = settings.eta, settings.exponent, settings.new_limit
    rows, padded = costs.shape
    shifts = padded - 2
    most = shifts // 2
    side = polar.half_width.size
    for y in range(rows):
        radius = max(polar.border[path[y] + 1] - 128, 0)
        quarter_y, quarter_x = position(radius, y << 8, polar.cosine, polar.sine)
        a = address_at(source, quarter_y, quarter_x, stride, plane, fractions)
        e = y + most
        line[0, e] = colours[a]
        line[1, e] = colours[a + 1]
        line[2, e] = colours[a - 1]
        line[3, e] = colours[a + stride]
        line[4, e] = colours[a - stride]
    for beside in range(1, 5):
        inside, outside, contrast = line[0], line[beside], line[4 + beside]
        for e in range(most, most + rows):
            contrast[e] = squared_distance(inside[e], outside[e])
    for each in line:  # which is closed, and at most a quarter of it is repeated at either end
        for e in range(most):
            each[e] = each[rows + e]
            each[most + rows + e] = each[most + e]
    for y in range(rows):
        cosine, sine = polar.cosine[y], polar.sine[y]
        if polar.cut_cosine[y] >= polar.cut_sine[y]:
            place = np.int64(polar.cut_x[y, path[y]])
            free = is_free_x(context.locked, place)
            if cosine > 0:
                place += 1
                old, before, direction = context.here[place], context.beside_x[place], 1
            else:
                old, before, direction = context.here[place], context.beside_x[place], 2
        else:
            place = np.int64(polar.cut_y[y, path[y]])
            free = is_free_y(context.locked, place, side)
            if sine > 0:
                old, before, direction = (
                    context.here[place + side],
                    context.beside_y[place + side],
                    3,
                )
            else:
                old, before, direction = context.here[place], context.beside_y[place], 4
        weight = (
            polar.cut_weight[path[y]] * np.int64(polar.cut_cosine[y] + polar.cut_sine[y]) + _HALF
        ) >> WEIGHT_BITS
        weight = np.int32(0 if free else weight)
        new, after_new = line[0, y : y + shifts], line[direction, y : y + shifts]
        contrast = line[4 + direction, y : y + shifts]
        old_contrast = squared_distance(old, before)
        row = costs[y, 1 : 1 + shifts]
        for k in range(shifts):
            both = np.int32(contrast[k] + old_contrast)
            cost = cost_beside(new[k], after_new[k], old, before, both, eta, exponent) >> halved
            cost = cost if cost < limit else limit
            row[k] = np.int32(np.int32(cost * weight) + np.int32(_HALF)) >> WEIGHT_BITS
        costs[y, 0] = BLOCKED
        costs[y, 1 + shifts] = BLOCKED
        row = steps[y]
        for k in range(padded):
            row[k] = k * settings.penalty
