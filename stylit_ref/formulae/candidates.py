"""Where PatchMatch looks: candidates of propagation, of random search, and of the level before."""

import numpy as np
from numba import njit

from stylit_ref.randomness.philox import uniform_below

PROPAGATION_DISTANCES = (4, 2, 1)
"""Jump flood distances (thesis 3.3)."""


@njit
def clamp(value, low, high):
    """``value`` moved into ``[low, high]``."""
    return min(max(value, low), high)


@njit
def neighbour_offsets(distance):
    """Where the neighbours are that propagate: right, below, left, above (thesis 3.3).

    The order counts: of equal candidates the first stays.
    """
    return (0, distance), (distance, 0), (0, -distance), (-distance, 0)


@njit
def propagation_candidate(neighbour_y, neighbour_x, dy, dx, radius, source_height, source_width):
    """Assignment of the neighbour at offset ``(dy, dx)``, shifted back by the offset.

    ``NNF(P ⊙ (dy, dx)) ⊙ (-dy, -dx)`` clamped to the source (thesis 2.4 and 3.3):
    the candidate that continues the neighbour's coherent area.
    """
    y = clamp(neighbour_y - dy, radius, source_height - 1 - radius)
    x = clamp(neighbour_x - dx, radius, source_width - 1 - radius)
    return y, x


@njit
def upsampled_assignment(coarse_nnf, y, x, radius, source_height, source_width):
    """Assignment that a target pixel takes from the next coarser level (UpsampleNNF, thesis 2.3).

    Twice its parent's coordinates plus its own offset from twice the parent, clamped to the
    centres the source has.
    """
    parent_y, parent_x = min(y // 2, coarse_nnf.shape[0] - 1), min(x // 2, coarse_nnf.shape[1] - 1)
    fine_y = 2 * coarse_nnf[parent_y, parent_x, 0] + (y - 2 * parent_y)
    fine_x = 2 * coarse_nnf[parent_y, parent_x, 1] + (x - 2 * parent_x)
    return (
        clamp(fine_y, radius, source_height - 1 - radius),
        clamp(fine_x, radius, source_width - 1 - radius),
    )


@njit
def random_candidate(
    word_y, word_x, centre_y, centre_x, search_radius, radius, source_height, source_width
):
    """Uniform patch centre in the square of ``search_radius`` around an assignment.

    The square is cut to the centres the source has (thesis 2.4 and 3.3).
    ``word_y`` and ``word_x`` are random 32-bit words.
    """
    low_y = max(centre_y - search_radius, radius)
    low_x = max(centre_x - search_radius, radius)
    high_y = min(centre_y + search_radius, source_height - 1 - radius)
    high_x = min(centre_x + search_radius, source_width - 1 - radius)
    y = low_y + uniform_below(word_y, np.int64(high_y - low_y + 1))
    x = low_x + uniform_below(word_x, np.int64(high_x - low_x + 1))
    return y, x
