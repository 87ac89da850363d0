"""Bytes as a page holds them: whole numbers that come out of it exactly as they went in.

Colours of a lossless WebP stay numbers in a browser, since no colour profile is attached and alpha
is not used. Whatever is no image is packed by deflate.
"""

import io
import zlib
from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image

WEBP, DEFLATE = "webp", "deflate"

LARGEST_WEBP = 16383
"""The longest side of a WebP, in pixels."""


class Piece(NamedTuple):
    """Packed bytes.

    Attributes
    ----------
    name : str
        What the page calls it.
    coding : str
        ``webp`` or ``deflate``.
    packed : bytes
    size : int
        How many bytes it holds.
    sum : int
        Their CRC-32, by which a page sees that it is damaged.
    """

    name: str
    coding: str
    packed: bytes
    size: int
    sum: int

    def facts(self) -> dict[str, Any]:
        """What the page's table of contents says of it."""
        return {"name": self.name, "coding": self.coding, "bytes": self.size, "sum": self.sum}


def of_colours(name: str, colours: NDArray[np.uint8]) -> Piece:
    """Pack an image.

    Parameters
    ----------
    name : str
    colours : (H, W, 3) uint8

    Returns
    -------
    Piece
    """
    if max(colours.shape[:2]) > LARGEST_WEBP:
        return of_bytes(name, colours.tobytes())
    packed = io.BytesIO()
    # A larger effort takes ten times as long and saves three bytes of a thousand.
    Image.fromarray(colours).save(packed, "WEBP", lossless=True, quality=90, method=5)
    content = colours.tobytes()
    return Piece(name, WEBP, packed.getvalue(), len(content), zlib.crc32(content))


def of_bytes(
    name: str, content: bytes, strategies: Iterable[int] = (zlib.Z_DEFAULT_STRATEGY,)
) -> Piece:
    """Pack bytes that are no image.

    Parameters
    ----------
    name : str
    content : bytes
    strategies : iterable of int, optional
        Of zlib; the one that packs best is taken.

    Returns
    -------
    Piece
    """
    packed = min((_deflated(content, strategy) for strategy in strategies), key=len)
    return Piece(name, DEFLATE, packed, len(content), zlib.crc32(content))


def _deflated(content, strategy):
    packer = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS, zlib.DEF_MEM_LEVEL, strategy)
    return packer.compress(content) + packer.flush()
