"""Voting with another style image, at its own bit depth and possibly enlarged."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.formulae.voting import voted_pixel
from stylit_ref.machine.kernel import kernel


@kernel()
def replay_vote(
    style: NDArray[np.uint8 | np.uint16 | np.float32],
    means: NDArray[np.float64],
    nnf: NDArray[np.int32],
    patch_width: int,
    scale: int,
) -> None:
    """Mean of the votes as in :func:`stylit_ref.passes.vote.vote`, at ``scale`` times the size.

    Parameters
    ----------
    style : (scale * H_A, scale * W_A, n) uint8, uint16 or float32
    means : (scale * H_B, scale * W_B, n) float64
        Overwritten at pixels that an assigned patch covers; not rounded.
    nnf : (H_B, W_B, 2) int32
        Negative where nothing is assigned.
    patch_width, scale : int
    """
    height, width = nnf.shape[:2]
    radius = patch_width // 2
    for fine_y in prange(means.shape[0]):
        y, offset_y = fine_y // scale, fine_y % scale
        for fine_x in range(means.shape[1]):
            x, offset_x = fine_x // scale, fine_x % scale
            votes = 0
            for near_y in range(max(y - radius, 0), min(y + radius + 1, height)):
                for near_x in range(max(x - radius, 0), min(x + radius + 1, width)):
                    if nnf[near_y, near_x, 0] < 0:
                        continue
                    voted_y, voted_x = voted_pixel(nnf, y, x, near_y, near_x)
                    source_y, source_x = voted_y * scale + offset_y, voted_x * scale + offset_x
                    for c in range(style.shape[2]):
                        value = np.float64(style[source_y, source_x, c])
                        means[fine_y, fine_x, c] = (
                            means[fine_y, fine_x, c] + value if votes else value
                        )
                    votes += 1
            if votes:
                for c in range(style.shape[2]):
                    means[fine_y, fine_x, c] /= votes
