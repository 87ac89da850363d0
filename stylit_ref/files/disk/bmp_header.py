"""Which bits of a 32-bit BMP file are red, green, blue and alpha, where its header says so."""

import struct
from pathlib import Path

BLUE_FIRST = 0xFF0000, 0xFF00, 0xFF
"""Bits of red, green and blue as OpenImageIO reads them, whatever the header says."""

_BITS_PER_PIXEL, _COMPRESSION, _MASKS = 28, 30, 54
_BITFIELDS = 3, 6


def channel_masks(file: str | Path) -> tuple[int, int, int, int] | None:
    """Read the masks of a 32-bit BMP file.

    Parameters
    ----------
    file : str or Path

    Returns
    -------
    tuple of 4 int or None
        Of red, green, blue and alpha, 0 where there is none; None if the header has no masks.
    """
    with Path(file).open("rb") as content:
        header = content.read(_MASKS + 16)
    if len(header) < _MASKS + 16:
        return None
    (header_size,) = struct.unpack_from("<I", header, 14)
    (bits,) = struct.unpack_from("<H", header, _BITS_PER_PIXEL)
    (compression,) = struct.unpack_from("<I", header, _COMPRESSION)
    if bits != 32 or compression not in _BITFIELDS:
        return None
    red, green, blue, alpha = struct.unpack_from("<4I", header, _MASKS)
    return red, green, blue, alpha if header_size >= 56 or compression == 6 else 0
