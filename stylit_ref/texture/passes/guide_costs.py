"""What all pixels of S cost by their guides."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.texture.formulae.guide_cost import guide_cost


@kernel()
def _guide_costs(addresses, guide_colours, guide, weight, costs):
    height, width = addresses.shape
    for y in prange(height):
        for x in range(width):
            costs[y, x] = guide_cost(guide_colours[addresses[y, x]], guide[y, x], weight)


def guide_costs(
    addresses: NDArray[np.int32],
    guide_colours: NDArray[np.int32],
    guide: NDArray[np.int32],
    weight: int,
    costs: NDArray[np.int64],
) -> None:
    """Compute the guide cost of every pixel.

    Parameters
    ----------
    addresses : (H, W) int32
    guide_colours : (n,) int32
        Guides of the exemplars, packed.
    guide : (H, W) int32
        The guide that each pixel should have, packed.
    weight : int
        From :func:`stylit_ref.texture.formulae.guide_cost.fixed_guide_weight`.
    costs : (H, W) int64
        Receives them.
    """
    _guide_costs(addresses, guide_colours, guide, weight, costs)
