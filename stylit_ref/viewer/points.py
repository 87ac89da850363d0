"""What a view shows, point by point, as a piece of a page; ``src/points.ts`` reads it."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.viewer.pieces import Piece, of_bytes
from stylit_ref.views.positions import Positions

SKY = 65535
"""The label where nothing is."""


def of_points(name: str, positions: Positions, camera: NDArray[np.float64]) -> Piece:
    """Pack the label and the inverse depth of every pixel.

    On a plane inverse depths are linear along a row, and so are the bits of a float of one
    magnitude. So what is packed are second differences of bits, which are mostly near 0.

    Parameters
    ----------
    name : str
    positions : Positions
    camera : (3, 4) float64
        The matrix M of the view (:mod:`stylit_ref.views.interpolation.formulae.transfer`).

    Returns
    -------
    Piece
        Byte by byte, the lowest first: the labels less those to the left; then the bits of float32
        less twice those to the left, plus those left of them.
    """
    labels, inverse = seen(positions, camera)
    bits = inverse.view(np.uint32)
    planes = _planes(_differences(labels), 2)
    planes += _planes(_differences(_differences(bits)), 4)
    return of_bytes(name, np.stack(planes).tobytes())


def seen(
    positions: Positions, camera: NDArray[np.float64]
) -> tuple[NDArray[np.uint16], NDArray[np.float32]]:
    """Labels, and inverse depths: 0 where nothing is, or what lies behind the camera."""
    depth = positions.points.astype(np.float64) @ camera[2, :3] + camera[2, 3]
    is_seen = (positions.labels >= 0) & (depth > 0)
    inverse = np.where(is_seen, 1 / np.where(is_seen, depth, 1), 0).astype(np.float32)
    return np.where(is_seen, positions.labels % SKY, SKY).astype(np.uint16), inverse


def _differences(numbers):
    """To what is on the left, around the end of the numbers."""
    return np.diff(numbers, axis=1, prepend=numbers.dtype.type(0))


def _planes(numbers, count):
    return [(numbers >> 8 * k & 255).astype(np.uint8) for k in range(count)]
