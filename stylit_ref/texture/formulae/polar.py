"""The polar map T of a patch, its normalization N (section 4, Appendix A), as tables of integers.

A patch is a disc of radius R around a pixel. T turns it into a rectangle of W = N_ρ R columns,
radii, and H = 2π N_θ R rows, angles. A cut is a column for every row, so a radius for every angle.
What a pass needs of T is computed once, in the tables below: which pixel edge a piece of a cut
crosses, and what it weighs. Angles enter as integers, rounded here and nowhere else, so that ports
can take the tables as they are.

Two weightings. ``printed`` is N of the paper, 2π x / (H N_ρ²): the area of a sample. Multiplied by
N_ρ², as the paper does for H, it is N_ρ times the length of a row's arc. ``arc_length`` weighs
existing seams by area too, but the pieces of a cut by their lengths: the arc of a row for H, the
width of a column for V. (Appendix A asks that a sum over the polar table be the sum over the disc.
Both fulfil it for existing seams. A cut of constant cost shows the difference: it costs its length
by arc length, and N_ρ times that as printed.)
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined

WEIGHT_BITS = 10
"""Weights and direction cosines are integers of this many fractional bits."""

MARGIN = 2
"""Pixels around a patch that its window holds: the neighbours of its border, and theirs."""

BLOCKED = (1 << 30) - 1
"""The value of a state of the dynamic programming that no cut may pass."""

WEIGHTINGS = "arc_length", "printed"


class Polar(NamedTuple):
    """T for one radius.

    A window is the square of n = 2 (R + :data:`MARGIN`) + 1 pixels around a patch's centre, row by
    row; a place is an index into it. The edge x of a place lies between it and the pixel to its
    right, the edge y between it and the pixel below. Weights are in units of 2**-10.

    Attributes
    ----------
    cut_x, cut_y : (H, W) uint16 or int32
        Places of the edges that a cut between column x and x + 1 crosses in row y.
    step_x, step_y : (H, W) uint16 or int32
        Places of the edges that a cut crosses at column x between rows y and y + 1.
    inside : (H, W) uint16 or int32
        The place of a sample of the disc, in the middle of a column.
    cut_cosine, cut_sine, step_cosine, step_sine : (H,) int32
        Absolute values of the cosine and the sine of a row, and between it and the next.
    cut_weight, step_weight, area : (W,) int32
        Lengths, or what is printed in their place, and areas.
    half_width : (n,) int32
        How far the disc of radius R + 1.5 reaches from the middle of each row of a window: what
        any edge of a cut may need.
    cosine, sine : (H + 1,) int32
        Of the middle of every row; the last repeats the first.
    border : (W + 1,) int32
        The radius of a cut before column x, in pixels times 2**8.
    radius_at : (n * n,) int32
        Distance of a place from the centre, in pixels times 2**8.
    angle_at : (n * n,) int32
        Its angle in rows, times 2**8.
    """

    cut_x: NDArray[np.integer]
    cut_y: NDArray[np.integer]
    step_x: NDArray[np.integer]
    step_y: NDArray[np.integer]
    inside: NDArray[np.integer]
    cut_cosine: NDArray[np.int32]
    cut_sine: NDArray[np.int32]
    step_cosine: NDArray[np.int32]
    step_sine: NDArray[np.int32]
    cut_weight: NDArray[np.int32]
    step_weight: NDArray[np.int32]
    area: NDArray[np.int32]
    half_width: NDArray[np.int32]
    cosine: NDArray[np.int32]
    sine: NDArray[np.int32]
    border: NDArray[np.int32]
    radius_at: NDArray[np.int32]
    angle_at: NDArray[np.int32]


def polar_size(radius: int, radial_samples: float, angular_samples: float) -> tuple[int, int]:
    """H and W, the rows and columns of the polar table (section 4)."""
    rows = _nearest(angular_samples * 2 * np.pi * radius)
    return max(8, int(rows)), max(1, int(_nearest(radial_samples * radius)))


@inlined
def row_of(angle: int, rows: int) -> int:
    """The row nearest to an angle in 1/256 rows."""
    row = (angle + 128) >> 8
    return row - rows if row >= rows else row


@lru_cache(maxsize=32)
def make_polar(radius: int, radial_samples: float, angular_samples: float, weighting: str) -> Polar:
    """The tables of T.

    Parameters
    ----------
    radius : int
        R, in pixels.
    radial_samples, angular_samples : float
        N_ρ and N_θ, samples a pixel along the radius and along the border.
    weighting : {"arc_length", "printed"}
    """
    rows, columns = polar_size(radius, radial_samples, angular_samples)
    radial_samples = columns / radius  # whole columns: the last cut is at R, not beyond the window
    centre = radius + MARGIN
    side = 2 * centre + 1
    angles = np.arange(rows)[:, None] * (2 * np.pi / rows)
    between = angles + np.pi / rows
    borders = np.arange(1, columns + 1)[None, :] / radial_samples
    middles = (np.arange(columns) + 0.5)[None, :] / radial_samples
    arc = 2 * np.pi / rows

    def places(y, x):
        index = (y + centre) * side + x + centre
        return np.ascontiguousarray(index.astype(np.uint16 if side**2 <= 1 << 16 else np.int32))

    def edges(radii, angle):
        y, x = radii * np.sin(angle), radii * np.cos(angle)
        return places(_nearest(y), _floor(x)), places(_floor(y), _nearest(x))

    area = middles[0] * arc / radial_samples
    if weighting == "printed":
        cut_weight, step_weight = borders[0] * radial_samples * arc, area
    else:
        cut_weight, step_weight = borders[0] * arc, np.full(columns, 1 / radial_samples)
    offsets = np.arange(-centre, centre + 1)
    y, x = np.meshgrid(offsets, offsets, indexing="ij")
    chord = np.maximum((2 * radius + 3) ** 2 - 4 * offsets**2, 0) // 4
    return Polar(
        *edges(borders, angles),
        *edges(middles, between),
        places(_nearest(middles * np.sin(angles)), _nearest(middles * np.cos(angles))),
        *(_fixed(abs(of(angle[:, 0]))) for angle in (angles, between) for of in (np.cos, np.sin)),
        _fixed(cut_weight),
        _fixed(step_weight),
        _fixed(area),
        np.sqrt(chord).astype(np.int32),
        _fixed(np.cos(np.append(angles, 0.0))),
        _fixed(np.sin(np.append(angles, 0.0))),
        _nearest(np.arange(columns + 1) * (256 / radial_samples)).astype(np.int32),
        _nearest(np.hypot(y, x).ravel() * 256).astype(np.int32),
        (_nearest(np.arctan2(y, x).ravel() * (rows * 128 / np.pi)) % (rows * 256)).astype(np.int32),
    )


class CostLimits(NamedTuple):
    """How large costs may be in the tables of a patch, so that no cut overflows 32 bits.

    What decides on a patch in the end is computed without limits.

    Attributes
    ----------
    new : int
        Of one edge that a cut crosses; larger ones are cut off.
    existing : int
        Of the two edges of a pixel that a patch hides, of either sign; larger ones are cut off.
    hidden : int
        Of all that a patch can hide. Where there is more, as in white noise, all costs are halved
        until there is not (:func:`halvings`).
    """

    new: int
    existing: int
    hidden: int


def cost_limits(polar: Polar) -> CostLimits:
    """The limits for patches of one size.

    A state of the dynamic programming that would cost more than BLOCKED counts as blocked, so only
    what is added in one row must fit. All that can be saved is less than half of BLOCKED: a cut
    through a blocked state never looks cheaper than that.
    """
    rows, one = polar.cut_x.shape[0], 1 << WEIGHT_BITS
    largest = max(int(polar.cut_weight.max()), int(polar.step_weight.max()), one)
    across = 1.5 * int(polar.step_weight.sum()) / one
    new = min((1 << 28) / across, ((1 << 31) - 1) / (1.5 * largest))
    existing = (1 << 31) / (int(polar.area.max()) + 1)
    areas = np.broadcast_to(polar.area, polar.inside.shape)
    a_pixel = np.bincount(polar.inside.ravel(), areas.ravel()).max() / one
    hidden = (BLOCKED // 2 - rows * (polar.area.size + 2)) / a_pixel
    return CostLimits(int(new), int(existing) - 1, int(hidden))


@inlined
def halvings(total: int, most: int) -> int:
    """How often a total is halved until it is at most ``most``."""
    count = 0
    while total >> count > most:
        count += 1
    return count


def _nearest(values):
    """Round half up; what is a tie but for the last bits of a sine is a tie on every machine."""
    return _floor(values + 0.5)


def _floor(values):
    return np.floor(np.floor(values * (1 << 20) + 0.5) / (1 << 20)).astype(np.int64)


def _fixed(values):
    return _nearest(values * (1 << WEIGHT_BITS)).astype(np.int32)
