"""Patch similarity δ (thesis 2.1, and procedure SSD of 3.2)."""

import numpy as np
from numba import njit
from numpy.typing import NDArray


@njit
def delta(
    source: NDArray[np.uint8],
    target: NDArray[np.uint8],
    weights: NDArray[np.int64],
    patch_width: int,
    y: int,
    x: int,
    source_y: int,
    source_x: int,
) -> int:
    r"""Weighted sum of squared differences between two patches.

    .. math:: \delta(P, Q) = \frac{\mu}{n_g} \sum_{guides} (f^P - f^Q)^2
              + \frac{1}{n_s} \sum_{style} (f^P - f^Q)^2

    Parameters
    ----------
    source : (H_A, W_A, C) uint8
        Packed source texture :math:`\bar A` (:mod:`stylit_ref.metric.packing`).
    target : (H_B + 2 radius, W_B + 2 radius, C) uint8
        Packed target texture :math:`\bar B`, its edge pixels repeated ``radius``
        times, so that every target pixel is the centre of a whole patch.
    weights : (C,) int64
        μ/n_g and 1/n_s in fixed point, 0 for padding channels.
    y, x : int
        Centre of the target patch P, in unpadded coordinates.
    source_y, source_x : int
        Centre of the source patch Q, at least ``radius`` from the border.

    Returns
    -------
    int64
        δ in fixed point, exact in any order of the terms.
    """
    return squared_differences(source, target, weights, patch_width, y, x, source_y, source_x, 0)


@njit(forceinline=True)
def squared_differences(
    source: NDArray[np.uint8],
    target: NDArray[np.uint8],
    weights: NDArray[np.int64],
    patch_width: int,
    y: int,
    x: int,
    source_y: int,
    source_x: int,
    first_channel: int,
) -> int:
    """The part of δ from ``first_channel`` on; other parameters as above."""
    radius = patch_width // 2
    total = np.int64(0)
    for dy in range(patch_width):
        for dx in range(patch_width):
            for c in range(first_channel, source.shape[2]):
                f_p = np.int64(target[y + dy, x + dx, c])
                f_q = np.int64(source[source_y - radius + dy, source_x - radius + dx, c])
                total += weights[c] * (f_p - f_q) * (f_p - f_q)
    return total
