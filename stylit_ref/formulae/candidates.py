"""Where PatchMatch looks: candidates of propagation and of random search."""

import numpy as np
from numba import njit

from stylit_ref.formulae.philox import uniform_below


@njit
def clamp(value, low, high):
    """``value`` moved into ``[low, high]``."""
    return min(max(value, low), high)


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
