"""Nearest-neighbour fields as pieces of a page; ``src/fields.ts`` reads them.

Half of the patches go on from a pixel close by, and the rest begin anywhere in the style. So first
it is told for every pixel which one its patch goes on from, and then where those lie that go on
from none. Little else repeats: matches, as deflate looks for them, would cost more than they save.
"""

import zlib

import numpy as np
from numpy.typing import NDArray

from stylit_ref.viewer.pieces import Piece, of_bytes

BEFORE = (
    (0, -1), (-1, 0), (-1, 1), (-1, -1), (0, -2), (-2, 0),
    (-2, 1), (-1, 2), (-2, -1), (-1, -2), (-2, 2), (-2, -2),
)  # fmt: skip
"""Rows and columns to the pixels that a patch may go on from, the closest first."""

NEW = len(BEFORE)
"""In place of one of them, where a patch begins."""

_FAR = 2
_NOWHERE = np.iinfo(np.int32).max


def of_field(name: str, nnf: NDArray[np.int32]) -> Piece:
    """Pack a field.

    Parameters
    ----------
    name : str
    nnf : (H, W, 2) int32
        Centres ``(y, x)``, each from 0 to 65535.

    Returns
    -------
    Piece
    """
    return of_bytes(name, field_bytes(nnf), (zlib.Z_HUFFMAN_ONLY, zlib.Z_RLE))


def field_bytes(nnf: NDArray[np.int32]) -> bytes:
    """A field as bytes that deflate packs well.

    Parameters
    ----------
    nnf : (H, W, 2) int32

    Returns
    -------
    bytes
        For each pixel one of ``BEFORE``, or ``NEW``. Then, of the new ones, the differences of y
        and x to the pixel before, modulo 65536 and folded (0, -1, 1, -2 become 0, 1, 2, 3): four
        low bits of y and of x, those of y lower; eight middle bits of y; eight of x; four high bits
        of y and of x, left out if all are 0.
    """
    origins = origins_of(nnf)
    steps = np.diff(nnf.reshape(-1, 2), axis=0, prepend=0)[origins.ravel() == NEW]
    signed = (steps + 32768 & 65535) - 32768
    y, x = np.where(signed < 0, -2 * signed - 1, 2 * signed).T
    planes = [y & 15 | (x & 15) << 4, y >> 4 & 255, x >> 4 & 255]
    high = y >> 12 | x >> 12 << 4
    if high.any():
        planes.append(high)
    return origins.tobytes() + np.concatenate(planes).astype(np.uint8).tobytes()


def origins_of(nnf: NDArray[np.int32]) -> NDArray[np.uint8]:
    """The closest pixel that a patch goes on from.

    Parameters
    ----------
    nnf : (H, W, 2) int32

    Returns
    -------
    (H, W) uint8
        Its number in ``BEFORE``, or ``NEW``.
    """
    height, width = nnf.shape[:2]
    offsets = nnf - np.moveaxis(np.mgrid[:height, :width], 0, -1)
    around = np.pad(offsets, ((_FAR, 0), (_FAR, _FAR), (0, 0)), constant_values=_NOWHERE)
    origins = np.full((height, width), NEW, np.uint8)
    for number, (down, right) in reversed(list(enumerate(BEFORE))):
        top, left = _FAR + down, _FAR + right
        there = around[top : top + height, left : left + width]
        origins[(there == offsets).all(axis=2)] = number
    return origins
