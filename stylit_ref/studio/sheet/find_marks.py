"""Find the marks of a sheet in a photograph, and tell which is which."""

from itertools import chain

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import (
    binary_fill_holes,
    find_objects,
    gaussian_filter,
    label,
    map_coordinates,
    uniform_filter,
)

from stylit_ref.studio.sheet.layout import CODES
from stylit_ref.studio.sheet.perspective import homography, least_turn, through

_SMALLEST = 12
"""Least side of a mark in pixels: two for each of its cells."""

_LEAST_TURN = 0.25
"""Of its area, what the sides of a mark span at each corner: in a square it is all."""

_WRONG_CELLS = 2
"""So many may be misread: two codes differ in at least six."""

_BLACK = 0.75
"""A pixel is dark that is so much darker than what lies around it."""


def find_marks(grey: NDArray[np.float32]) -> dict[int, NDArray[np.float64]]:
    """Find the marks.

    Parameters
    ----------
    grey : (H, W) float32
        Within about 2000 pixels on each side, for the sake of time.

    Returns
    -------
    dict of int to (4, 2) float64
        Of each mark that was found: its number in the layout, and its corners in the order of the
        sheet, to a pixel or two. Of two marks with one number the larger counts.
    """
    around = uniform_filter(grey, max(grey.shape) // 10 | 1)
    numbers, _ = label(gaussian_filter(grey, 0.7) < _BLACK * around)
    found = {}
    for number, place in enumerate(find_objects(numbers), 1):
        sides = [part.stop - part.start for part in place]
        if min(sides) < _SMALLEST or max(sides) > max(grey.shape) // 3:
            continue
        outline = _quadrilateral(numbers[place] == number)
        if outline is None:
            continue
        outline += place[1].start, place[0].start
        named = _named(grey, outline)
        if named is None:
            continue
        corner, outline = named
        if corner not in found or _area(outline) > _area(found[corner]):
            found[corner] = outline
    return found


def _quadrilateral(blob):
    """The corners of a dark thing, clockwise, if it is one with four corners."""
    filled = binary_fill_holes(blob)
    area = filled.sum()
    if area < 0.35 * filled.size:
        return None
    y, x = np.nonzero(filled)
    points = np.stack([x, y], axis=1) + 0.5
    first = points[_squared(points - points.mean(axis=0)).argmax()]
    opposite = points[_squared(points - first).argmax()]
    dx, dy = opposite - first
    aside = (points - first) @ (-dy, dx)
    corners = np.array([first, points[aside.argmin()], opposite, points[aside.argmax()]])
    corners += 0.5 * np.sign(corners - corners.mean(axis=0))  # to the outside of the pixels
    is_square = 0.85 < _area(corners) / area < 1.2 and least_turn(corners) > _LEAST_TURN * area
    return corners if is_square else None


def _named(grey, outline):
    """Which mark it is, and its corners in the order of the sheet; None if it is none."""
    to_photograph = homography(_UNIT, outline)
    cells = _cells(grey, to_photograph)
    inside = cells[1:-1, 1:-1]
    frame, paper = inside[_FRAME], cells[~_INNER]
    black, white = np.median(frame), np.median(paper)
    middle = (black + white) / 2
    if white - black < 0.2 * white or np.mean(frame < middle) < 0.9:
        return None
    read = inside[1:-1, 1:-1] > middle
    wrong = {
        (corner, turns): np.count_nonzero(np.rot90(read, turns) != code)
        for corner, code in enumerate(_CODES)
        for turns in range(4)
    }
    corner, turns = min(wrong, key=wrong.__getitem__)
    if wrong[corner, turns] > _WRONG_CELLS:
        return None
    return corner, np.roll(outline, -turns, axis=0)


def _cells(grey, to_photograph):
    """The mean of each of eight by eight cells: the mark and what is around it."""
    within = (np.arange(3) - 1) * 0.2
    steps = (np.arange(8) - 0.5)[:, None] + within
    y, x = np.meshgrid(steps.ravel() / 6, steps.ravel() / 6, indexing="ij")
    places = through(to_photograph, np.stack([x, y], axis=-1)) - 0.5
    values = map_coordinates(grey, (places[..., 1], places[..., 0]), order=1, mode="nearest")
    return values.reshape(8, 3, 8, 3).mean(axis=(1, 3))


def _squared(offsets):
    return (offsets**2).sum(axis=1)


def _area(corners):
    x, y = corners.T
    return abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


_UNIT = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float)
_CODES = np.array([list(map(int, chain(*code))) for code in CODES]).reshape(-1, 4, 4) > 0
_FRAME = np.pad(np.zeros((4, 4), bool), 1, constant_values=True)
_INNER = np.pad(np.ones((6, 6), bool), 1)
