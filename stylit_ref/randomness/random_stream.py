"""The Philox counter and key of each draw.

The counter names the draw, so that draws can be made in any order:

==========  ==================================================================
word 0      target pixel, ``y * width + x`` (or the position in a shuffle)
word 1      draw of that pixel, four random words each
word 2      vote (EM iteration) * 65536 + PatchMatch iteration
word 3      purpose * 65536 + level (1 is the coarsest)
key         the seed, low word first
==========  ==================================================================
"""

import numpy as np
from numba import njit

from stylit_ref.randomness.philox import FourWords, philox4x32

RANDOM_NNF, RANDOM_SEARCH, COMMIT_ORDER, RETRIEVAL_NNF, RETRIEVAL_SEARCH = 1, 2, 3, 4, 5

# Those of texture synthesis, 16 to 31.
WHITE_NOISE, GRID, PATCHES, LABELS = 16, 17, 18, 19

# Those of the real-time method, 32 to 47; a vote is an iteration, and an iteration its half.
REALTIME_NNF, REALTIME_SEARCH = 32, 33

ITERATIONS = 1 << 16
"""Number of iterations that the counter can tell apart; the same for votes and levels."""


def random_stream(
    seed: int, purpose: int, level: int = 0, vote: int = 0, iteration: int = 0
) -> FourWords:
    """Counter words 2 and 3 and the key of a pass.

    Parameters
    ----------
    seed : int
        In ``[0, 2**64)``.
    purpose : int
        One of the constants above.
    level, vote, iteration : int
        Each below 65536.

    Returns
    -------
    tuple of 4 uint32
    """
    words = (vote << 16 | iteration, purpose << 16 | level, seed & 0xFFFFFFFF, seed >> 32)
    return tuple(np.uint32(word) for word in words)


@njit
def random_words(stream: FourWords, position: int, draw: int) -> FourWords:
    """Four random 32-bit words of a pixel's draw."""
    return philox4x32(position, draw, stream[0], stream[1], stream[2], stream[3])
