"""What an iteration did."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.texture.formulae.polar import Polar
from stylit_ref.texture.formulae.seam_cost import ONE
from stylit_ref.texture.passes.placement import ACCEPTED, DEFORMED, UNTRIED


@dataclass(frozen=True)
class Iteration:
    """What an iteration did.

    Attributes
    ----------
    number : int
        From 1.
    radius, max_deformation : int
        R and D_max that it used; R is smaller than asked for where the texture is too small for it.
    cells, tried, accepted, deformed : int
        Patches that had a place, that were fitted, accepted, and accepted deformed.
    cost : float
        The cost of S after it, in units of M.
    """

    number: int
    radius: int
    max_deformation: int
    cells: int
    tried: int
    accepted: int
    deformed: int
    cost: float


class Offered(NamedTuple):
    """The patches of an iteration, as :func:`stylit_ref.texture.passes.placement.iterate` has them.

    Attributes
    ----------
    cells : (n, 2) int64
    patches : (n, places) int32
    outcomes, changes : (n,) int64
    polar : Polar
    radius, max_deformation : int
    """

    cells: NDArray[np.int64]
    patches: NDArray[np.int32]
    outcomes: NDArray[np.int64]
    changes: NDArray[np.int64]
    polar: Polar
    radius: int
    max_deformation: int

    @property
    def accepted(self) -> NDArray[np.bool_]:
        """Which were accepted."""
        return (self.outcomes == ACCEPTED) | (self.outcomes == DEFORMED)


def told(offered: Offered, number: int, cost: int) -> Iteration:
    """What the iteration ``number`` did, after which S costs ``cost``, in 1/256 of M."""
    return Iteration(
        number=number,
        radius=offered.radius,
        max_deformation=offered.max_deformation,
        cells=len(offered.cells),
        tried=int(np.count_nonzero(offered.outcomes != UNTRIED)),
        accepted=int(np.count_nonzero(offered.accepted)),
        deformed=int(np.count_nonzero(offered.outcomes == DEFORMED)),
        cost=cost / ONE,
    )
