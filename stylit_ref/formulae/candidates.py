"""Candidates of PatchMatch: from propagation, random search and the coarser level."""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from stylit_ref.randomness.philox import uniform_below

PROPAGATION_DISTANCES = (4, 2, 1)
"""Jump flood distances (thesis 3.3)."""


@njit
def clamp(value: int, low: int, high: int) -> int:
    """``value`` moved into ``[low, high]``."""
    return min(max(value, low), high)


@njit
def neighbour_offsets(distance: int) -> tuple[tuple[int, int], ...]:
    """Offsets of the neighbours in propagation: right, below, left, above (thesis 3.3).

    The order matters: of equally good candidates the first is kept.
    """
    return (0, distance), (distance, 0), (0, -distance), (-distance, 0)


@njit
def propagation_candidate(
    neighbour_y: int,
    neighbour_x: int,
    dy: int,
    dx: int,
    radius: int,
    source_height: int,
    source_width: int,
) -> tuple[int, int]:
    """The assignment of the neighbour at offset ``(dy, dx)``, shifted back by the offset.

    This is ``NNF(P ⊙ (dy, dx)) ⊙ (-dy, -dx)``, clamped to the source (thesis 2.4 and 3.3). It
    continues the neighbour's coherent area.
    """
    y = clamp(neighbour_y - dy, radius, source_height - 1 - radius)
    x = clamp(neighbour_x - dx, radius, source_width - 1 - radius)
    return y, x


@njit
def upsampled_assignment(
    coarse_nnf: NDArray[np.int32],
    y: int,
    x: int,
    radius: int,
    source_height: int,
    source_width: int,
) -> tuple[int, int]:
    """The assignment that a target pixel takes from the coarser level (UpsampleNNF, thesis 2.3).

    It is twice the parent's assignment, plus the pixel's offset from twice the parent's position,
    clamped to the source's patch centres.
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
    word_y: int,
    word_x: int,
    centre_y: int,
    centre_x: int,
    search_radius: int,
    radius: int,
    source_height: int,
    source_width: int,
) -> tuple[int, int]:
    """A uniformly random patch centre in the square of ``search_radius`` around an assignment.

    The square is clipped to the source's patch centres (thesis 2.4 and 3.3). ``word_y`` and
    ``word_x`` are random 32-bit words.
    """
    low_y = max(centre_y - search_radius, radius)
    low_x = max(centre_x - search_radius, radius)
    high_y = min(centre_y + search_radius, source_height - 1 - radius)
    high_x = min(centre_x + search_radius, source_width - 1 - radius)
    y = low_y + uniform_below(word_y, np.int64(high_y - low_y + 1))
    x = low_x + uniform_below(word_x, np.int64(high_x - low_x + 1))
    return y, x
