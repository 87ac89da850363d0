"""Frames and the motion between them: a grid of views, a sequence, a ring, or any other graph."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError


class Motion(NamedTuple):
    """Where the points that a frame shows appear in a neighbour.

    Attributes
    ----------
    field : (H, W, 2) float32
        (x, y) in pixels, x to the right and y downwards, to be added to each pixel of the frame
        that a picture is shifted to.
    visible : (H, W) bool
        Whether the neighbour shows the pixel's point.
    """

    field: NDArray[np.float32]
    visible: NDArray[np.bool_]


Edges = Mapping[tuple[int, int], Motion]
"""The motion from frame ``to`` into frame ``other``, by ``(to, other)``: pictures are shifted from
``other`` to ``to``. The two directions are two edges."""


def sequence_pairs(frames: int, *, ring: bool = False) -> Iterator[tuple[int, int]]:
    """Pairs ``(to, other)`` of neighbours in a sequence.

    Parameters
    ----------
    frames : int
    ring : bool
        Whether the last frame is followed by the first.

    Yields
    ------
    tuple of 2 int
    """
    for frame in range(frames):
        for other in (frame - 1, frame + 1):
            if ring and frames > 2:
                yield frame, other % frames
            elif 0 <= other < frames:
                yield frame, other


def grid_pairs(rows: int, columns: int) -> Iterator[tuple[int, int]]:
    """Pairs ``(to, other)`` of neighbours in a grid of views, which are numbered row by row.

    Parameters
    ----------
    rows, columns : int

    Yields
    ------
    tuple of 2 int
    """
    for row in range(rows):
        for column in range(columns):
            for other_row, other_column in (
                (row - 1, column),
                (row, column - 1),
                (row, column + 1),
                (row + 1, column),
            ):
                if 0 <= other_row < rows and 0 <= other_column < columns:
                    yield row * columns + column, other_row * columns + other_column


def check_edges(edges: Edges, frames: int, size: tuple[int, int]) -> dict[tuple[int, int], Motion]:
    """Edges that fit frames of a size.

    Parameters
    ----------
    edges : mapping
    frames : int
        How many there are.
    size : tuple of 2 int
        Rows and columns of each.

    Returns
    -------
    dict
        Fields as float32, and visibility as bool.

    Raises
    ------
    InputError
        If an edge leads from or to no frame or has another size.
    """
    checked = {}
    for (to, other), motion in edges.items():
        name = f"edges[{to}, {other}]"
        if not (0 <= to < frames and 0 <= other < frames) or to == other:
            raise InputError(
                f"joins frames {to} and {other}; the frames are 0 to {frames - 1}, and an edge "
                "joins two of them",
                parameter=name,
            )
        field = as_array(motion.field, f"{name}.field")
        visible = as_array(motion.visible, f"{name}.visible")
        if field.shape != (*size, 2) or visible.shape != size:
            raise InputError(
                f"has a field of shape {field.shape} and visibility of shape {visible.shape}; "
                f"frames of {size[1]}x{size[0]} need {(*size, 2)} and {size}",
                parameter=name,
            )
        checked[to, other] = Motion(
            np.ascontiguousarray(field, np.float32), np.ascontiguousarray(visible, np.bool_)
        )
    return checked
