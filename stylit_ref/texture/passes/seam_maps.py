"""What all seams of S cost: M^S for every edge (section 4)."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.texture.formulae.seam_cost import edge_cost


@kernel()
def _seam_maps(addresses, colours, stride, eta, exponent, seams_x, seams_y):
    height, width = addresses.shape
    for y in prange(height):
        below = addresses[y + 1 if y + 1 < height else 0]
        for x in range(width):
            right = addresses[y, x + 1 if x + 1 < width else 0]
            seams_x[y, x] = edge_cost(colours, addresses[y, x], right, 1, eta, exponent)
            seams_y[y, x] = edge_cost(colours, addresses[y, x], below[x], stride, eta, exponent)


def seam_maps(
    addresses: NDArray[np.int32],
    colours: NDArray[np.int32],
    stride: int,
    eta: int,
    exponent: int,
    seams_x: NDArray[np.int32],
    seams_y: NDArray[np.int32],
) -> None:
    """Compute what the edge to the right of every pixel costs, and the edge below it.

    S wraps around: the last column meets the first.

    Parameters
    ----------
    addresses : (H, W) int32
        S, as addresses into ``colours``.
    colours : (n,) int32
        Packed colours of the exemplars (:class:`stylit_ref.texture.exemplars.Exemplars`).
    stride : int
        From a pixel to the one below it.
    eta, exponent : int
        η and d of M.
    seams_x, seams_y : (H, W) int32
        Receive the costs.
    """
    _seam_maps(addresses, colours, stride, eta, exponent, seams_x, seams_y)
