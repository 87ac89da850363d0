"""Where the points that a view shows appear in other views: the motion of every pixel."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.views.interpolation.formulae.transfer import transferred


@kernel()
def transfer(
    inverse: NDArray[np.float64], transfers: NDArray[np.float64], motion: NDArray[np.float32]
) -> None:
    """Compute V of each of K views (3.3.2).

    Parameters
    ----------
    inverse : (H, W) float64
        1 / depth; 0 is the sky, which does not move: it is paper.
    transfers : (K, 3, 4) float64
        From this view's pixels to each view's.
    motion : (K, H, W, 2) float32
        Written: (x, y), to be added to a pixel; infinite where a point is behind a camera.
    """
    views, height, width = motion.shape[:3]
    for y in prange(height):
        for k in range(views):
            for x in range(width):
                if inverse[y, x] > 0:
                    across, down = transferred(transfers[k], x, y, inverse[y, x])
                    motion[k, y, x, 0], motion[k, y, x, 1] = across - x, down - y
                else:
                    motion[k, y, x, 0] = motion[k, y, x, 1] = 0.0
