"""The tables of the dynamic programming: H, V and ℰ of section 4 ("Patch cost").

All are sums of edge costs times lengths or areas, rounded half up to integers. The sums of V and ℰ
along a row are running sums: V(x1, x2, y) is a difference of two.
"""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined, subroutine
from stylit_ref.texture.formulae.polar import BLOCKED, WEIGHT_BITS, Polar

_HALF = np.int32(1 << (WEIGHT_BITS - 1))


@inlined
def _weighted(value, weight):
    return np.int32(np.int32(value * weight) + _HALF) >> WEIGHT_BITS


@inlined
def _directed(cost_x, weight_x, cost_y, weight_y):
    total = np.int32(np.int32(cost_x * weight_x) + np.int32(cost_y * weight_y))
    return np.int32(total + _HALF) >> WEIGHT_BITS


@subroutine
def existing_seams(seams: NDArray[np.int32], polar: Polar, saved: NDArray[np.int32]) -> None:
    """ℰ: the (H, W) int32 costs of all seams that a cut after column x would hide in row y."""
    rows, columns = saved.shape
    area = polar.area
    for y in range(rows):
        places, row = polar.inside[y], saved[y]
        total = np.int32(0)
        for x in range(columns):
            total = np.int32(total + _weighted(seams[places[x]], area[x]))
            row[x] = total


@subroutine
def cut_costs(
    new_x: NDArray[np.int32],
    new_y: NDArray[np.int32],
    saved: NDArray[np.int32],
    polar: Polar,
    max_jump: int,
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
    crossing, steps : (H, W + 2 max_jump) int32
        Receive them.
    """
    rows, columns = saved.shape
    cut_weight, step_weight = polar.cut_weight, polar.step_weight
    last = max_jump + columns
    for y in range(rows):
        places_x, places_y, hidden = polar.cut_x[y], polar.cut_y[y], saved[y]
        cosine, sine = polar.cut_cosine[y], polar.cut_sine[y]
        row = crossing[y, max_jump:last]
        for x in range(columns):
            cost = _directed(new_x[places_x[x]], cosine, new_y[places_y[x]], sine)
            row[x] = _weighted(cost, cut_weight[x]) - hidden[x]
        crossing[y, :max_jump] = BLOCKED
        crossing[y, last:] = BLOCKED
        places_x, places_y = polar.step_x[y], polar.step_y[y]
        cosine, sine = polar.step_cosine[y], polar.step_sine[y]
        row = steps[y, max_jump:last]
        total = np.int32(0)
        for x in range(columns):
            cost = _directed(new_x[places_x[x]], sine, new_y[places_y[x]], cosine)
            total = np.int32(total + _weighted(cost, step_weight[x]))
            row[x] = total
        steps[y, :max_jump] = 0
        steps[y, last:] = total


@subroutine
def end_rays(
    valid: NDArray[np.uint8],
    stride: int,
    source: int,
    polar: Polar,
    max_jump: int,
    crossing: NDArray[np.int32],
) -> None:
    """Block every cut that would hold a pixel outside the exemplar."""
    rows, columns = polar.inside.shape
    side = polar.half_width.size
    centre = side // 2
    for y in range(rows):
        for x in range(columns):
            place = np.int64(polar.inside[y, x])
            if not valid[source + (place // side - centre) * stride + place % side - centre]:
                crossing[y, max_jump + max(x - 1, 0) : max_jump + columns] = BLOCKED
                break
