"""Which bytes of a 32-bit BMP file are red, green, blue and alpha, where its header says so.

OpenImageIO takes them for blue, green, red and alpha, whatever the header says.
"""

import struct
from pathlib import Path

from stylit_ref.errors import InputError

_NUMBERS = {0xFF0000: 0, 0xFF00: 1, 0xFF: 2, 0xFF000000: 3}
"""By the bits of a byte, the number of the channel that OpenImageIO makes of it."""

_BITS_PER_PIXEL, _COMPRESSION, _MASKS = 28, 30, 54
_BITFIELDS = 3, 6


def channel_numbers(file: str | Path) -> dict[str, int] | None:
    """Find the channels of a 32-bit BMP file.

    Parameters
    ----------
    file : str or Path

    Returns
    -------
    dict of str to int or None
        By ``R``, ``G``, ``B`` and, if there is one, ``A``, the number of the channel that
        OpenImageIO makes of it; None if the header does not say.

    Raises
    ------
    InputError
        If a channel has other bits than those of a byte.
    """
    masks = _masks(file)
    if masks is None:
        return None
    roles = "RGBA" if masks[3] else "RGB"
    if not set(masks[: len(roles)]) <= _NUMBERS.keys():
        raise InputError(f"{file}: has channels of other than 8 bits; save it as .png")
    return {role: _NUMBERS[mask] for role, mask in zip(roles, masks, strict=False)}


def _masks(file):
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
