"""Where things lie on the sheet.

Lengths are dots of 1/300 inch, from the upper left corner of the picture, x to the right and y
down. What is found in a photograph so does not depend on the size of the paper, nor on a printer
that shrinks the page.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

DOTS_PER_INCH = 300

CELL = 32
"""Side of a cell of a mark, 2.7 mm."""

MARK = 6 * CELL
"""Side of a mark: a black frame around four by four cells."""

CODES = (
    ("0010", "1111", "0010", "1101"),
    ("1001", "1000", "1011", "1111"),
    ("0100", "1101", "1000", "0100"),
    ("0001", "0110", "1011", "1000"),
)
"""The cells of the marks, 1 is white: upper left, upper right, lower right, lower left.

Each differs in at least six cells from every other one and from itself, however they are turned.
"""

NAMES = "upper left", "upper right", "lower right", "lower left"
"""Of the corners, in the order of everything that has one for each."""

_GAP = 28
"""Between the picture and the marks, on both axes."""

_MOST = 1840, 2500
"""Width and height of the largest picture that fits on A4 and on Letter."""


class Layout(NamedTuple):
    """A picture and the marks around it.

    Attributes
    ----------
    width, height : int
        Of the picture, in dots.
    """

    width: int
    height: int

    @property
    def corners(self) -> NDArray[np.float64]:
        """(4, 2), the corners of the picture (x, y)."""
        return _box(0, 0, self.width, self.height)

    @property
    def marks(self) -> NDArray[np.float64]:
        """(4, 4, 2), the corners of each mark (x, y)."""
        near = np.array([-_GAP - MARK] * 2), np.array([self.width + _GAP, self.height + _GAP])
        return np.stack(
            [
                _box(near[right][0], near[lower][1], MARK, MARK)
                for right, lower in ((0, 0), (1, 0), (1, 1), (0, 1))
            ]
        )


def layout_of(width: int, height: int) -> Layout:
    """The layout of a picture as large as the paper allows.

    Parameters
    ----------
    width, height : int
        Of the picture, in pixels; only their ratio counts.
    """
    scale = min(_MOST[0] / width, _MOST[1] / height)
    return Layout(max(1, round(width * scale)), max(1, round(height * scale)))


def _box(x, y, width, height):
    return np.array([(x, y), (x + width, y), (x + width, y + height), (x, y + height)], float)
