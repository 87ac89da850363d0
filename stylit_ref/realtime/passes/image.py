"""Pixels as the passes read them: rows with a border, in one flat array."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.vector_patch import SLACK


class Image(NamedTuple):
    """Pixels of a few bytes each; how many is known to whoever reads them.

    Attributes
    ----------
    values : (n,) uint8
    stride : int
        Pixels from row to row.
    border : int
        Pixels around the image that repeat its edge.
    height, width : int
        Without the border.
    """

    values: NDArray[np.uint8]
    stride: int
    border: int
    height: int
    width: int


def make_image(height: int, width: int, border: int, lanes: int) -> Image:
    """An image of zeros."""
    stride = width + 2 * border
    size = (height + 2 * border) * stride * lanes
    return Image(np.zeros(size + SLACK, np.uint8), stride, border, height, width)


def whole(image: Image, lanes: int) -> NDArray[np.uint8]:
    """A view of all pixels, (height + 2 border, stride, lanes)."""
    rows = image.height + 2 * image.border
    values = image.values[: rows * image.stride * lanes]
    return values.reshape(rows, image.stride, lanes)


def interior(image: Image, lanes: int) -> NDArray[np.uint8]:
    """A view of the pixels without the border, (height, width, lanes)."""
    border = image.border
    return whole(image, lanes)[border : border + image.height, border : border + image.width]
