"""What propagation need not look at again, in a byte for each source patch (StyLit's retrievals).

A target patch that is fixed stays fixed until the vote. So while the claim of a source patch is
free, its error never rises, and a candidate that it has rejected is never better later. A
neighbour whose claim is still the one that was offered at this distance before need not be asked
again. Only a patch that has lost its claim must ask all its neighbours once more.
"""

import numpy as np
from numba import njit

from stylit_ref.formulae.candidates import PROPAGATION_DISTANCES

_DISTANCES = len(PROPAGATION_DISTANCES)

CHANGED = (1 << _DISTANCES) - 1
"""A bit for each distance of propagation: since it last ran, the claim has changed."""

ASKING = CHANGED << _DISTANCES
"""Likewise: since it last ran, the claim was lost, so that all neighbours must be asked."""

LOST = 1 << (2 * _DISTANCES)
"""The claimed target patch is fixed; every free one is better."""

UNKNOWN = CHANGED | ASKING
"""The state of a claim that no neighbour has been offered."""


def distance_bit(distance: int) -> int:
    """The bit of a distance within ``CHANGED``."""
    return 1 << PROPAGATION_DISTANCES.index(distance)


@njit(inline="always")
def must_ask(state: int, neighbour_state: int, bit: int) -> bool:
    """Whether the claim of a neighbour may be better than any it offered before."""
    return (neighbour_state | state >> _DISTANCES) & bit != 0


@njit(inline="always")
def next_state(state: int, bit: int, changed: bool, lost: bool) -> np.uint8:
    """The state after a pass; ``bit`` is that of its distance, 0 for a random search."""
    kept = state & UNKNOWN & ~(bit | bit << _DISTANCES)
    return np.uint8(kept | (CHANGED if changed else 0) | (LOST if lost else 0))
