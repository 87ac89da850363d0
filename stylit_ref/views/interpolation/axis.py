"""An axis of a grid of views: where its rows or columns stand, in degrees or in steps."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

from stylit_ref.views.interpolation.formulae.weights import fading_weight, linear_weight


class Between(NamedTuple):
    """The two rows or columns around a place.

    Attributes
    ----------
    low, high : int
        Their numbers; equal where an axis has one alone.
    at : float
        The place, as the positions count.
    low_at, high_at : float
        Where the two are.
    """

    low: int
    high: int
    at: float
    low_at: float
    high_at: float

    def linear(self) -> int:
        """The weight of ``high`` in proportion, of 256."""
        return linear_weight(self.at, self.low_at, self.high_at)

    def fading(self, band: float) -> int:
        """The weight of ``high`` in a fade, of 256."""
        return fading_weight(self.at, self.low_at, self.high_at, band)


@dataclass(frozen=True)
class Axis:
    """Where the rows or columns of a grid stand; unevenly too.

    Attributes
    ----------
    positions : tuple of float
        Ascending.
    unit : str
        ``degrees``, or ``steps`` where the cameras are not known.
    is_ring : bool
        Whether the first follows the last, 360 degrees after itself.
    """

    positions: tuple[float, ...]
    unit: str = "degrees"
    is_ring: bool = False

    @property
    def middle(self) -> float:
        """The place that is called 0: the middle, or where a ring begins."""
        return self.positions[0] if self.is_ring else (self.positions[0] + self.positions[-1]) / 2

    @property
    def reach(self) -> tuple[float, float]:
        """The least and the largest place, from the middle."""
        return self.positions[0] - self.middle, self.positions[-1] - self.middle

    @property
    def gaps(self) -> tuple[float, ...]:
        """How far neighbours are apart; none where there is one position alone."""
        positions = self.positions
        if self.is_ring:
            positions = (*positions, positions[0] + 360.0)
        return tuple(high - low for low, high in pairwise(positions))

    def holds(self, place: float) -> bool:
        """Whether a place, counted from the middle, lies on the axis; NaN does not."""
        if self.is_ring:
            return abs(place) < float("inf")
        low, high = self.reach
        return low <= place <= high

    def around(self, place: float) -> Between:
        """The two positions around a place that the axis holds.

        Of a place on a position it is the lower of the two, unless it is the last one.

        Parameters
        ----------
        place : float
            From the middle.
        """
        positions, count = self.positions, len(self.positions)
        at = place + self.middle
        if self.is_ring:
            at = positions[0] + (at - positions[0]) % 360.0
            positions = (*positions, positions[0] + 360.0)
        if count == 1:
            return Between(0, 0, at, positions[0], positions[0])
        low = 0
        while low < len(positions) - 2 and at >= positions[low + 1]:
            low += 1
        return Between(low, (low + 1) % count, at, positions[low], positions[low + 1])


def steps_axis(count: int) -> Axis:
    """An axis whose positions are as far apart as its views are numbered."""
    return Axis(tuple(map(float, range(count))), "steps")


def closes_ring(azimuths: Sequence[float]) -> bool:
    """Whether the gap from the last to the first is no wider than those between the others."""
    gaps = [after - before for before, after in pairwise(azimuths)]
    closing = azimuths[0] + 360.0 - azimuths[-1]
    return len(azimuths) > 2 and 0 < closing <= 1.001 * max(gaps)
