"""The painting that a photograph shows, at the size of the picture that was printed."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from scipy.ndimage import map_coordinates

from stylit_ref.errors import InputError
from stylit_ref.studio.sheet.find_marks import find_marks
from stylit_ref.studio.sheet.fit import fit_sheet
from stylit_ref.studio.sheet.layout import NAMES, layout_of
from stylit_ref.studio.sheet.paper_white import evened, paper_places
from stylit_ref.studio.sheet.perspective import drawn_through, homography, least_turn, through

_LONGEST = 1600
"""Pixels within which marks are looked for; larger photographs are shrunk."""

_WORST = 6.0
"""Most dots that the edges of marks may lie away from their places: half a millimetre."""

_PAPER_STEP = 16
"""Dots between two places on the paper that are looked at."""

_LEAST_SEEN = 0.6
"""Of the places on the paper; from fewer the light on the picture would be a guess."""

_LEAST_TURN = 16
"""Square pixels that the sides of a picture span at each corner."""

_FEW = "none", "one", "two"

_OTHERWISE = "or show the corners of the picture yourself"


class Registered(NamedTuple):
    """A painting, and where it was found.

    Attributes
    ----------
    painting : (H, W, 3) uint8
    corners : (4, 2) float64
        (x, y) of its corners in the photograph, in the order of
        :data:`~stylit_ref.studio.sheet.layout.NAMES`; pixel (x, y) reaches to (x + 1, y + 1).
    """

    painting: NDArray[np.uint8]
    corners: NDArray[np.float64]


def register(photograph: NDArray[np.uint8], size: tuple[int, int]) -> Registered:
    """Find the marks of the sheet, and undo perspective and light.

    Parameters
    ----------
    photograph : (H, W, 3) uint8
        As :func:`~stylit_ref.studio.sheet.photograph.read_photograph` reads it.
    size : (int, int)
        Width and height of the picture that was printed, in pixels.

    Returns
    -------
    Registered

    Raises
    ------
    InputError
        If fewer than three marks are found, a mark lies outside the photograph, or they do not lie
        as on the sheet of such a picture.
    """
    layout = layout_of(*size)
    shrink = -(-max(photograph.shape) // _LONGEST)
    small = Image.fromarray(photograph).convert("L").reduce(shrink)
    grey = np.asarray(small, np.float32)
    found = find_marks(grey)
    if len(found) < 3:
        raise InputError(
            f"the photograph shows {_FEW[len(found)]} of the four marks; take one "
            f"of the whole sheet from above, sharp and in even light, {_OTHERWISE}"
        )
    fit = fit_sheet(grey, found, layout)
    _check_in_view(fit.matrix, found, layout, grey.shape)
    if fit.error > _WORST:
        width, height = size
        raise InputError(
            "the marks in the photograph do not lie as on the sheet for "
            f"{width}x{height} pixels; print the sheet of this scene and keep it flat, {_OTHERWISE}"
        )
    corners = through(np.diag([shrink, shrink, 1]) @ fit.matrix, layout.corners)
    return Registered(register_corners(photograph, corners, size), corners)


def register_corners(
    photograph: NDArray[np.uint8], corners: NDArray[np.float64], size: tuple[int, int]
) -> NDArray[np.uint8]:
    """Undo perspective and light where somebody has shown the corners of the picture.

    Parameters
    ----------
    photograph : (H, W, 3) uint8
    corners : (4, 2) float
        As in :class:`Registered`.
    size : (int, int)
        As for :func:`register`.

    Returns
    -------
    (H, W, 3) uint8

    Raises
    ------
    InputError
        If the corners do not go clockwise around a picture within the photograph.
    """
    corners = np.asarray(corners, float)
    _check_corners(corners, photograph.shape)
    layout = layout_of(*size)
    of_pixels = homography(_corners_of(*size), corners)
    of_dots = homography(layout.corners, corners)
    image = Image.fromarray(photograph)
    picture = drawn_through(image, of_pixels, size)
    places = paper_places(layout.width, layout.height, _PAPER_STEP)
    seen = through(of_dots, places)
    height, width = photograph.shape[:2]
    inside = ((seen >= 0) & (seen <= (width, height))).all(axis=1)
    if inside.mean() < _LEAST_SEEN:
        return picture
    shrink = _per_step(corners, layout)
    paper = np.asarray(image.reduce(shrink))
    at = (seen[inside] / shrink - 0.5).T[::-1]
    colours = [
        map_coordinates(paper[..., channel], at, order=1, mode="nearest") for channel in range(3)
    ]
    in_pixels = places[inside] * size / (layout.width, layout.height)
    return evened(picture, in_pixels, np.stack(colours, axis=1))


def _check_in_view(matrix, found, layout, shape):
    for number, (name, mark) in enumerate(zip(NAMES, layout.marks, strict=True)):
        places = through(matrix, mark)
        outside = ((places < 0) | (places > shape[::-1])).any()
        if number not in found and outside:
            raise InputError(
                f"the photograph lacks the mark at the {name}; take one of the whole sheet, "
                f"{_OTHERWISE}"
            )


def _check_corners(corners, shape):
    if corners.shape != (4, 2) or not np.isfinite(corners).all():
        raise InputError("must be four points, each x and y", parameter="corners")
    height, width = shape[:2]
    within = ((corners >= (-width, -height)) & (corners <= (2 * width, 2 * height))).all()
    if not within or least_turn(corners) < _LEAST_TURN:
        raise InputError(
            "must go around the picture: upper left, upper right, lower right, lower left",
            parameter="corners",
        )


def _per_step(corners, layout):
    """Pixels of the photograph between two places on the paper, a whole number."""
    side = np.linalg.norm(corners[1] - corners[0]) / layout.width
    return max(1, int(side * _PAPER_STEP))


def _corners_of(width, height):
    return np.array([(0, 0), (width, 0), (width, height), (0, height)], float)
