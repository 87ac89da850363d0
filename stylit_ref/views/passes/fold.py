"""Fold the shifted pictures of the neighbours into this frame's B' (equation 3.1)."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.views.formulae.fold import ONE, folded, spread


@kernel()
def fold(
    own: NDArray[np.uint8],
    guides: NDArray[np.uint8],
    weights: NDArray[np.int64],
    mixed: NDArray[np.uint8],
    spreads: NDArray[np.uint8],
) -> None:
    """Compute M and √S.

    Parameters
    ----------
    own : (H, W, n) uint8
        B'.
    guides : (K, H, W, n) uint8
        G_c of K neighbours.
    weights : (K,) int64
        λ_c in units of 1/256.
    mixed : (H, W, n) uint8
        Written: M.
    spreads : (H, W, 1) uint8
        Written: √S.
    """
    everything = np.int64(ONE) + weights.sum()
    for y in prange(own.shape[0]):
        for x in range(own.shape[1]):
            deviation = np.int64(0)
            for c in range(own.shape[2]):
                value = np.int64(own[y, x, c])
                total, squares = ONE * value, ONE * value * value
                for k in range(guides.shape[0]):
                    value = np.int64(guides[k, y, x, c])
                    total += weights[k] * value
                    squares += weights[k] * value * value
                mixed[y, x, c] = folded(total, everything)
                deviation += everything * squares - total * total
            spreads[y, x, 0] = spread(deviation, everything)
