"""Which vectors another field confirms."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.views.formulae.vectors import fixed, is_consistent


@kernel()
def cancel(
    field: NDArray[np.float32],
    places: NDArray[np.int32],
    back: NDArray[np.float32],
    known: NDArray[np.bool_],
    cancels: NDArray[np.bool_],
) -> None:
    """Find the pixels whose motion forth and back cancels (Sundaram et al. 2010).

    Parameters
    ----------
    field : (H, W, 2) float32
        Into the other frame.
    places : (H, W, 2) int32
        Where each pixel lies there: (y, x), or -1 for nowhere.
    back : (H, W, 2) float32
        From the other frame's pixels to this frame.
    known : (H, W) bool
        Where ``back`` holds.
    cancels : (H, W) bool
        Written; False where a pixel lies nowhere, or where ``back`` is not known.
    """
    for y in prange(places.shape[0]):
        for x in range(places.shape[1]):
            row, column = places[y, x, 0], places[y, x, 1]
            cancels[y, x] = False
            if row >= 0 and known[row, column]:
                cancels[y, x] = is_consistent(
                    fixed(field[y, x, 0]),
                    fixed(field[y, x, 1]),
                    fixed(back[row, column, 0]),
                    fixed(back[row, column, 1]),
                )
