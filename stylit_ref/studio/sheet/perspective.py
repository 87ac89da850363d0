"""How the sheet lies in a photograph: a homography, and pictures drawn through it.

A point is (x, y); pixel (x, y) covers the square from there to (x + 1, y + 1).
"""

import numpy as np
from numpy.typing import NDArray
from PIL import Image

_FINEST = 16
"""Most samples of an output pixel on each axis."""


def homography(points: NDArray[np.float64], others: NDArray[np.float64]) -> NDArray[np.float64]:
    """The homography that takes points to others, by least squares (Hartley's normalized DLT).

    Parameters
    ----------
    points, others : (N, 2) float
        At least four, no three of which lie on a line.

    Returns
    -------
    (3, 3) float64
    """
    to_unit, to_other = _normalizing(points), _normalizing(others)
    rows = []
    for (x, y), (u, v) in zip(through(to_unit, points), through(to_other, others), strict=True):
        rows.append([x, y, 1, 0, 0, 0, -u * x, -u * y, -u])
        rows.append([0, 0, 0, x, y, 1, -v * x, -v * y, -v])
    matrix = np.linalg.svd(np.array(rows))[2][-1].reshape(3, 3)
    matrix = np.linalg.inv(to_other) @ matrix @ to_unit
    return matrix / matrix[2, 2]


def through(matrix: NDArray[np.float64], points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Where a homography takes points (..., 2)."""
    taken = np.asarray(points, float) @ matrix[:, :2].T + matrix[:, 2]
    return taken[..., :2] / taken[..., 2:]


def least_turn(corners: NDArray[np.float64]) -> float:
    """The least of the four parallelograms that sides of a quadrilateral span.

    It is positive where the corners (4, 2) go clockwise around something convex, and the area of a
    rectangle.
    """
    x, y = (np.roll(corners, -1, axis=0) - corners).T
    return float((x * np.roll(y, -1) - y * np.roll(x, -1)).min())


def drawn_through(
    photograph: Image.Image, matrix: NDArray[np.float64], size: tuple[int, int]
) -> NDArray[np.uint8]:
    """The part of a photograph that becomes a picture, each pixel the mean of what it covers.

    Parameters
    ----------
    photograph : PIL image, RGB
    matrix : (3, 3) float64
        From pixels of the picture to those of the photograph.
    size : (int, int)
        Width and height of the picture.

    Returns
    -------
    (H, W, 3) uint8
        Black where the photograph ends.
    """
    width, height = size
    box = np.array([(0, 0), (width, 0), (width, height), (0, height)], float)
    sides = np.roll(through(matrix, box), -1, axis=0) - through(matrix, box)
    longest = np.hypot(*sides.T) / (width, height, width, height)
    samples = int(np.clip(np.ceil(longest.max() - 0.01), 1, _FINEST))
    finer = matrix @ np.diag([1 / samples, 1 / samples, 1])
    drawn = photograph.transform(
        (width * samples, height * samples),
        Image.Transform.PERSPECTIVE,
        (finer / finer[2, 2]).ravel()[:8],
        Image.Resampling.BICUBIC if samples == 1 else Image.Resampling.BILINEAR,
    )
    return np.asarray(drawn.reduce(samples))


def _normalizing(points):
    """Takes points to a mean of 0 and a mean distance of about 1 from it, which steadies sums."""
    middle = np.mean(points, axis=0)
    scale = 1 / max(np.std(points), 1e-12)
    return np.array([[scale, 0, -scale * middle[0]], [0, scale, -scale * middle[1]], [0, 0, 1]])
