"""Random initial assignments (RandomNNF, thesis 2.3; Kernel_RandomNNF, 3.4)."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.randomness.philox import FourWords, uniform_below
from stylit_ref.randomness.random_stream import random_words


@kernel()
def random_nnf(
    nnf: NDArray[np.int32],
    patch_width: int,
    source_height: int,
    source_width: int,
    stream: FourWords,
) -> None:
    """Assign a uniformly random source patch to every target patch.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
        Overwritten, except where it is negative (pixels a mask leaves alone).
    patch_width, source_height, source_width : int
    stream : tuple of 4 uint32
    """
    height, width = nnf.shape[:2]
    radius = patch_width // 2
    for y in prange(height):
        for x in range(width):
            if nnf[y, x, 0] >= 0:
                words = random_words(stream, y * width + x, 0)
                nnf[y, x, 0] = radius + uniform_below(words[0], source_height - 2 * radius)
                nnf[y, x, 1] = radius + uniform_below(words[1], source_width - 2 * radius)
