"""Find the triangle that each pixel shows."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.views.interpolation.formulae.edge import crossing

BAND = 16
"""Rows that are filled together."""


@kernel()
def rasterize(
    polygons: NDArray[np.float64],
    counts: NDArray[np.int32],
    planes: NDArray[np.float64],
    triangles: NDArray[np.int32],
    inverse: NDArray[np.float64],
) -> None:
    """Find the nearest triangle at the centre of each pixel.

    A centre on an edge belongs to the polygons on both sides. Of those that are equally near the
    first one counts.

    Parameters
    ----------
    polygons, counts
        As of :func:`~stylit_ref.views.interpolation.passes.clip.clip`.
    planes : (T, 3) float64
        Inverse depth as a x + b y + c.
    triangles : (H, W) int32
        Written: the number of the triangle, -1 where there is none.
    inverse : (H, W) float64
        Written: 1 / depth, 0 where there is none.
    """
    height, width = triangles.shape
    for band in prange(-(-height // BAND)):
        top, bottom = band * BAND, min((band + 1) * BAND, height) - 1
        for y in range(top, bottom + 1):
            for x in range(width):
                triangles[y, x], inverse[y, x] = -1, 0.0
        for t in range(polygons.shape[0]):
            count = counts[t]
            if count == 0:
                continue
            polygon = polygons[t]
            lowest = highest = polygon[0, 1]
            for k in range(1, count):
                lowest, highest = min(lowest, polygon[k, 1]), max(highest, polygon[k, 1])
            if highest < top or lowest > bottom:
                continue
            a, b, c = planes[t]
            for y in range(int(np.ceil(max(lowest, top))), int(min(highest, bottom)) + 1):
                left, right = np.inf, -np.inf
                for k in range(count):
                    after = (k + 1) % count
                    x, here = polygon[k]
                    other, there = polygon[after]
                    if here != there and min(here, there) <= y <= max(here, there):
                        at = crossing(x, here, other, there, y)
                        left, right = min(left, at), max(right, at)
                if not right >= 0 or not left <= width - 1:
                    continue
                row = b * y + c
                for x in range(int(np.ceil(max(left, 0))), int(min(right, width - 1)) + 1):
                    found = a * x + row
                    if found > inverse[y, x]:
                        triangles[y, x], inverse[y, x] = t, found
