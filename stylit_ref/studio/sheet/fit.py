"""How a sheet lies in a photograph, to a fraction of a pixel, from the edges of its marks."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter, map_coordinates
from scipy.optimize import least_squares

from stylit_ref.studio.sheet.layout import CELL, Layout
from stylit_ref.studio.sheet.perspective import homography, through

_ALONG = np.linspace(0.06, 0.94, 24)
"""Where on a side of a mark its edge is looked for."""

_FAR, _NEAR = 0.45 * CELL, 0.2 * CELL
"""How far from where it is expected, in dots: the frame of a mark is a cell thick."""

_SMOOTH = 1.0
"""Pixels; in a sharp scan the steepest place would depend on where an edge cuts a pixel."""

_LEAST_STEPS = 4
"""Half pixels to each side of an edge, however small the marks are."""

_FAINT = 0.35
"""An edge below this share of the usual steepness is covered by something."""


class Fit(NamedTuple):
    """How a sheet lies in a photograph.

    Attributes
    ----------
    matrix : (3, 3) float64
        From dots of the sheet to pixels.
    error : float
        Median distance of edges from where they should lie, in dots; infinite without edges.
    """

    matrix: NDArray[np.float64]
    error: float


def fit_sheet(
    grey: NDArray[np.float32], found: dict[int, NDArray[np.float64]], layout: Layout
) -> Fit:
    """Fit all four marks, of which three or four were found.

    What is visible of a mark counts in the end, also of the one that was not found: paint may cover
    a part of it.

    Parameters
    ----------
    grey : (H, W) float32
    found : dict of int to (4, 2) float64
        As :func:`~stylit_ref.studio.sheet.find_marks.find_marks` gives them.
    layout : Layout

    Returns
    -------
    Fit
    """
    corners = np.concatenate([layout.marks[number] for number in found])
    smooth = gaussian_filter(grey, _SMOOTH)
    matrix = homography(corners, np.concatenate(list(found.values())))
    error = np.inf
    for marks, reach in ((layout.marks[list(found)], _FAR), (layout.marks, _NEAR)):
        scale = _scale(matrix, layout)
        if not scale > 0:
            return Fit(matrix, np.inf)
        edges = _edges(smooth, matrix, marks, reach, 1 / scale)
        if len(edges.places) < 8 * len(_ALONG):
            return Fit(matrix, np.inf)
        matrix, error = _fitted(edges, matrix)
    return Fit(matrix, error)


class _Edges(NamedTuple):
    """Points on edges of marks: where they are seen, and on which lines of the sheet they lie."""

    places: NDArray[np.float64]
    normals: NDArray[np.float64]
    offsets: NDArray[np.float64]


def _edges(grey, matrix, marks, reach, pixel):
    start = marks.reshape(-1, 2)
    end = np.roll(marks, -1, axis=1).reshape(-1, 2)
    along = (end - start) / np.linalg.norm(end - start, axis=1, keepdims=True)
    outward = np.stack([along[:, 1], -along[:, 0]], axis=1)
    on_side = start[:, None] + _ALONG[:, None] * (end - start)[:, None]
    normal = np.broadcast_to(outward[:, None], on_side.shape)
    most = max(_LEAST_STEPS, int(2 * reach / pixel))
    steps = np.arange(-most, most + 1) * pixel / 2
    across = on_side[..., None, :] + steps[:, None] * normal[..., None, :]
    seen = through(matrix, across) - 0.5
    values = map_coordinates(grey, (seen[..., 1], seen[..., 0]), order=1, mode="nearest")
    rise = values[..., 2:] - values[..., :-2]  # from black to paper
    steepest = rise.argmax(axis=-1)
    best = np.clip(steepest, 1, rise.shape[-1] - 2)[..., None]
    before, at, after = (
        np.take_along_axis(rise, best + step, axis=-1)[..., 0] for step in (-1, 0, 1)
    )
    bend = before - 2 * at + after
    peak = np.where(bend < 0, 0.5 * (before - after) / np.minimum(bend, -1e-9), 0)
    shift = steps[best[..., 0] + 1] + np.clip(peak, -1, 1) * pixel / 2
    is_edge = steepest == best[..., 0]  # one that begins outside the reach is something else's
    clear = is_edge & (at > _FAINT * np.quantile(at, 0.75)) & (bend < 0)
    places = through(matrix, on_side + shift[..., None] * normal)
    offsets = (on_side * normal).sum(axis=-1)
    return _Edges(places[clear], normal[clear], offsets[clear])


def _fitted(edges, matrix):
    """The homography whose inverse brings the edges closest to their lines."""
    middle, scale = edges.places.mean(axis=0), edges.places.std()
    to_unit = np.array([[1, 0, -middle[0]], [0, 1, -middle[1]], [0, 0, scale]]) / scale
    places = through(to_unit, edges.places)
    begin = np.linalg.inv(to_unit @ matrix)
    begin = begin / begin[2, 2]

    def distances(values):
        back = np.append(values, 1).reshape(3, 3)
        return (through(back, places) * edges.normals).sum(axis=1) - edges.offsets

    best = least_squares(distances, begin.ravel()[:8], loss="soft_l1", x_scale="jac")
    back = np.append(best.x, 1).reshape(3, 3) @ to_unit
    matrix = np.linalg.inv(back)
    return matrix / matrix[2, 2], float(np.median(np.abs(distances(best.x))))


def _scale(matrix, layout):
    """Pixels of a dot, on the average; 0 or less if the picture is not seen from above."""
    corners = np.append(layout.corners, np.ones((4, 1)), axis=1) @ matrix.T
    if (corners[:, 2] <= 0).any():
        return 0.0
    x, y = (corners[:, :2] / corners[:, 2:]).T
    area = (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
    return np.sqrt(max(area, 0) / layout.width / layout.height)
