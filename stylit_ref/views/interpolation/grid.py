"""A grid of views: which of them stand around a place, and how much each counts there."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.views.interpolation.axis import Axis, Between
from stylit_ref.views.interpolation.formulae.weights import ONE


class Around(NamedTuple):
    """The views around a place: four, or two in a row, the closest first.

    Attributes
    ----------
    views : tuple of int
        Numbers of frames. Of those that are as close the one of the first row counts, then of the
        first column.
    linear, fading : tuple of int
        The weight of each, in units of 1/65536.
    """

    views: tuple[int, ...]
    linear: tuple[int, ...]
    fading: tuple[int, ...]


@dataclass(frozen=True)
class Grid:
    """A grid of views, by rows from below and columns from the left.

    Attributes
    ----------
    columns, rows : Axis
        Places to the right, and upwards.
    frames : tuple of tuple of int
        The number of the frame in each row and column.
    """

    columns: Axis
    rows: Axis
    frames: tuple[tuple[int, ...], ...]

    def check(self, place: tuple[float, float]) -> None:
        """Refuse a place outside of the grid.

        Raises
        ------
        InputError
        """
        for axis, at, what in zip(
            (self.columns, self.rows), place, ("to the right", "upwards"), strict=True
        ):
            if not axis.holds(at):
                low, high = axis.reach
                raise InputError(
                    f"{at:g} {axis.unit} {what} lies outside of the grid, which reaches from "
                    f"{low:g} to {high:g}; choose a place within it"
                )

    def between(self, place: tuple[float, float]) -> tuple[Between, Between]:
        """The columns and the rows around a place."""
        return self.columns.around(place[0]), self.rows.around(place[1])

    def around(self, place: tuple[float, float], band: float) -> Around:
        """The views around a place that :meth:`check` allows.

        Parameters
        ----------
        place : tuple of 2 float
            To the right and upwards, from the middle of the grid.
        band : float
            How wide a fade is, as a part of the way from view to view.

        Returns
        -------
        Around
        """
        across, upwards = self.between(place)
        found = []
        for row, row_at, linear_y, fading_y in _sides(upwards, band):
            for column, column_at, linear_x, fading_x in _sides(across, band):
                distance = (across.at - column_at) ** 2 + (upwards.at - row_at) ** 2
                weights = linear_x * linear_y, fading_x * fading_y
                found.append((distance, row, column, self.frames[row][column], *weights))
        found.sort()
        return Around(*zip(*(each[3:] for each in found), strict=True))

    def closest(self, place: tuple[float, float]) -> int:
        """The frame that is closest to a place."""
        return self.around(place, 0.0).views[0]


def _sides(between: Between, band: float) -> list[tuple[int, float, int, int]]:
    """A row or column, where it is, and its weights; once where both sides are one."""
    linear, fading = between.linear(), between.fading(band)
    if between.low == between.high:
        return [(between.low, between.low_at, ONE, ONE)]
    return [
        (between.low, between.low_at, ONE - linear, ONE - fading),
        (between.high, between.high_at, linear, fading),
    ]


def bilinear(values: NDArray[np.float64], place: tuple[Between, Between]) -> NDArray[np.float64]:
    """Values between those of a grid.

    Parameters
    ----------
    values : (rows, columns, ...) float64
    place : tuple of Between
        The columns and rows around it.

    Returns
    -------
    (...) float64
    """
    across, upwards = place
    low, high = (
        _linear(values[row, across.low], values[row, across.high], across)
        for row in (upwards.low, upwards.high)
    )
    return _linear(low, high, upwards)


def _linear(low, high, between):
    if between.low_at == between.high_at:
        return low
    share = (between.at - between.low_at) / (between.high_at - between.low_at)
    return low + share * (high - low)
