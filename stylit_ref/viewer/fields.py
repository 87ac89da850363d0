"""Nearest-neighbour fields as pieces of a page; ``src/fields.ts`` reads them."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.viewer.pieces import LARGEST_WEBP, Piece, of_bytes, of_colours

LARGEST_TWELVE_BITS = 4096
"""Styles with longer sides need more than 12 bits for y or x."""


def of_field(name: str, nnf: NDArray[np.int32], style_size: tuple[int, int]) -> Piece:
    """Pack a field: as colours where its numbers have 12 bits, which is a third smaller.

    Parameters
    ----------
    name : str
    nnf : (H, W, 2) int32
        Centres ``(y, x)``, each from 0 to 65535.
    style_size : tuple of 2 int
        Rows and columns of the style.

    Returns
    -------
    Piece
    """
    if max(style_size) <= LARGEST_TWELVE_BITS and max(nnf.shape[:2]) <= LARGEST_WEBP:
        return of_colours(name, colours_of(nnf))
    return of_bytes(name, differences_of(nnf))


def colours_of(nnf: NDArray[np.int32]) -> NDArray[np.uint8]:
    """Low byte of y, low byte of x, and four high bits of each, those of x first.

    Parameters
    ----------
    nnf : (H, W, 2) int32
        From 0 to 4095.

    Returns
    -------
    (H, W, 3) uint8
    """
    y, x = nnf[..., 0], nnf[..., 1]
    return np.stack([y & 255, x & 255, y >> 8 | x >> 8 << 4], axis=-1).astype(np.uint8)


def differences_of(nnf: NDArray[np.int32]) -> bytes:
    """Low and high bytes of y, then of x, less what a patch that goes on would have.

    That is the number to the left, and for x one more; for the first pixel of a row it comes from
    above, and for y one more. So 0 stands within a patch.

    Parameters
    ----------
    nnf : (H, W, 2) int32

    Returns
    -------
    bytes
    """
    planes = []
    for axis, (right, down) in enumerate(((0, 1), (1, 0))):
        number = nnf[..., axis]
        expected = np.empty_like(number)
        expected[:, 1:] = number[:, :-1] + right
        expected[1:, 0] = number[:-1, 0] + down
        expected[0, 0] = right
        difference = number - expected
        planes += [difference & 255, difference >> 8 & 255]
    return np.stack(planes).astype(np.uint8).tobytes()
