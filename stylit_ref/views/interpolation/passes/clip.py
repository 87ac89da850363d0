"""Bring the triangles of a mesh before a camera: polygons in pixels, cut off at the near plane."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.views.interpolation.formulae.edge import cut


@kernel()
def clip(
    corners: NDArray[np.float64],
    near: float,
    polygons: NDArray[np.float64],
    counts: NDArray[np.int32],
) -> None:
    """Cut triangles off at the near plane, and divide by depth.

    A ground may reach behind the camera. What is cut off a triangle leaves three or four corners.

    Parameters
    ----------
    corners : (T, 3, 3) float64
        (x z, y z, z) of the corners of every triangle.
    near : float
        The least depth that is seen, more than 0.
    polygons : (T, 4, 2) float64
        Written: (x, y) in pixels.
    counts : (T,) int32
        Written: the number of corners, 0 for a triangle that is not seen.
    """
    for t in prange(corners.shape[0]):
        count = 0
        for k in range(3):
            one, other = corners[t, k], corners[t, (k + 1) % 3]
            if one[2] > near:
                polygons[t, count, 0] = one[0] / one[2]
                polygons[t, count, 1] = one[1] / one[2]
                count += 1
            if (one[2] > near) != (other[2] > near):
                front, back = (one, other) if one[2] > near else (other, one)
                polygons[t, count, 0] = cut(front[0], back[0], front[2], back[2], near) / near
                polygons[t, count, 1] = cut(front[1], back[1], front[2], back[2], near) / near
                count += 1
        counts[t] = count
