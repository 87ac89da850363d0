"""The occurrence map Ω of a whole NNF, and its sums over patches (thesis 2.1, 3.2).

Let n be the number of target patches assigned to each source centre. Ω counts, at each source
pixel, the assigned patches that cover it, so it is the box sum of n. W, Ω summed over a patch, is
the box sum of Ω. All three are maps of integers, so the order of additions does not matter.
"""

import numpy as np
from numpy.typing import NDArray


def count_assignments(nnf: NDArray[np.int32], source_size: tuple[int, int]) -> NDArray[np.int32]:
    """n, the number of target patches assigned to each source centre.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
        Negative where a mask leaves the pixel alone.
    source_size : (int, int)
        Rows and columns of the source.

    Returns
    -------
    (H_A, W_A) int32
    """
    height, width = source_size
    assigned = nnf[:, :, 0] >= 0
    places = nnf[:, :, 0][assigned].astype(np.int64) * width + nnf[:, :, 1][assigned]
    counts = np.bincount(places, minlength=height * width)
    return counts.astype(np.int32).reshape(source_size)


def box_sum(values: NDArray[np.int32], patch_width: int) -> NDArray[np.int32]:
    """Sum over the patch around each pixel; values outside the image are zero.

    Parameters
    ----------
    values : (H, W) int32
    patch_width : int

    Returns
    -------
    (H, W) int32
    """
    radius = patch_width // 2
    height, width = values.shape
    padded = np.pad(values, radius)
    rows = sum(padded[dy : dy + height] for dy in range(patch_width))
    return sum(rows[:, dx : dx + width] for dx in range(patch_width))


def occurrence_map(
    nnf: NDArray[np.int32],
    omega: NDArray[np.int32],
    omega_sums: NDArray[np.int32],
    patch_width: int,
) -> None:
    """Ω and W of an NNF (InitOccurrenceMap, thesis 2.3).

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
        Negative where a mask leaves the pixel alone.
    omega, omega_sums : (H_A, W_A) int32
        Overwritten.
    patch_width : int
    """
    omega[:] = box_sum(count_assignments(nnf, omega.shape), patch_width)
    omega_sums[:] = box_sum(omega, patch_width)
