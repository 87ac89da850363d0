"""The tables of the dynamic programming: H, V and ℰ of section 4 ("Patch cost").

All are sums of edge costs times lengths or areas, rounded half up to integers. The sums of V and ℰ
along a row are running sums: V(x1, x2, y) is a difference of two.
"""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined, subroutine
from stylit_ref.machine.running_sum import LANES, add_up
from stylit_ref.texture.formulae.polar import BLOCKED, WEIGHT_BITS, Polar

_HALF = np.int32(1 << (WEIGHT_BITS - 1))


@inlined
def _weighted(value, weight):
    return np.int32(np.int32(value * weight) + _HALF) >> WEIGHT_BITS


@inlined
def _directed(cost_x, weight_x, cost_y, weight_y):
    total = np.int32(np.int32(cost_x * weight_x) + np.int32(cost_y * weight_y))
    return np.int32(total + _HALF) >> WEIGHT_BITS


@inlined
def _running_sums(row):
    """Replace a row by its running sums; returns the last."""
    total = np.int32(0)
    whole = row.size - row.size % LANES
    for x in range(0, whole, LANES):
        total = add_up(row, x, total)
    for x in range(whole, row.size):
        total = np.int32(total + row[x])
        row[x] = total
    return total


@subroutine
def existing_seams(
    seams: NDArray[np.int32], polar: Polar, halved: int, limit: int, saved: NDArray[np.int32]
) -> None:
    """ℰ: the (H, W) int32 costs of all seams that a cut after column x would hide in row y.

    Costs are halved ``halved`` times, then cut off at the limit, of either sign: beside locked
    pixels a patch may pay more than it hides.
    """
    rows, columns = saved.shape
    area = polar.area
    for y in range(rows):
        places, row = polar.inside[y], saved[y]
        for x in range(columns):
            row[x] = seams[places[x]]
        for x in range(columns):
            seam = row[x] >> halved
            seam = seam if seam < limit else limit
            seam = seam if seam > -limit else -limit
            row[x] = _weighted(seam, area[x])
        _running_sums(row)


@subroutine
def cut_costs(
    new_x: NDArray[np.int32],
    new_y: NDArray[np.int32],
    saved: NDArray[np.int32],
    polar: Polar,
    max_jump: int,
    edges: NDArray[np.int32],
    crossing: NDArray[np.int32],
    steps: NDArray[np.int32],
) -> None:
    """H - ℰ, and the running sums of V.

    Both tables have ``max_jump`` columns more on either side, so that no jump ends outside.

    Parameters
    ----------
    new_x, new_y : (n * n,) int32
    saved : (H, W) int32
    polar : Polar
    max_jump : int
    edges : (2, W) int32
        Room for the costs of a row's edges.
    crossing, steps : (H, W + 2 max_jump) int32
        Receive them.
    """
    rows, columns = saved.shape
    cut_weight, step_weight = polar.cut_weight, polar.step_weight
    last = max_jump + columns
    edge_x, edge_y = edges[0], edges[1]
    for y in range(rows):
        # Gathered first, one array at a time, and computed with then: the compiler finds vector
        # instructions for the last loop alone.
        places_x, places_y, hidden = polar.cut_x[y], polar.cut_y[y], saved[y]
        for x in range(columns):
            edge_x[x] = new_x[places_x[x]]
        for x in range(columns):
            edge_y[x] = new_y[places_y[x]]
        cosine, sine = polar.cut_cosine[y], polar.cut_sine[y]
        along = crossing[y, max_jump:last]
        for x in range(columns):
            cost = _directed(edge_x[x], cosine, edge_y[x], sine)
            along[x] = _weighted(cost, cut_weight[x]) - hidden[x]
        places_x, places_y = polar.step_x[y], polar.step_y[y]
        for x in range(columns):
            edge_x[x] = new_x[places_x[x]]
        for x in range(columns):
            edge_y[x] = new_y[places_y[x]]
        cosine, sine = polar.step_cosine[y], polar.step_sine[y]
        across = steps[y, max_jump:last]
        for x in range(columns):
            cost = _directed(edge_x[x], sine, edge_y[x], cosine)
            across[x] = _weighted(cost, step_weight[x])
        total = _running_sums(across)
        crossing[y, :max_jump] = BLOCKED
        crossing[y, last:] = BLOCKED
        steps[y, :max_jump] = 0
        steps[y, last:] = total


@subroutine
def end_rays(
    clearance: NDArray[np.uint16],
    stride: int,
    source: int,
    polar: Polar,
    max_jump: int,
    crossing: NDArray[np.int32],
) -> None:
    """Block every cut that would hold a pixel outside the exemplar.

    A ray goes as far at a time as the ``clearance`` of a pixel says that all are inside; the two
    pixels less are what rounding to the nearest pixel can take, at both ends.
    """
    rows, columns = polar.inside.shape
    side = polar.half_width.size
    centre = side // 2
    columns_a_pixel = (columns << 8) // polar.border[columns]
    for y in range(rows):
        x = np.int64(0)
        while x < columns:
            place = np.int64(polar.inside[y, x])
            clear = np.int64(
                clearance[source + (place // side - centre) * stride + place % side - centre]
            )
            if clear == 0:
                crossing[y, max_jump + max(x - 1, 0) : max_jump + columns] = BLOCKED
                break
            x += max((clear - 2) * columns_a_pixel, 1)
