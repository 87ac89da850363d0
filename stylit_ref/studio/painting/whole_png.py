"""Whether a PNG file is whole: its decoder writes to the terminal if it is not."""

import zlib
from pathlib import Path

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_FRAME = 12
"""Bytes of a chunk beside its data: its length and its type before, its checksum after."""


def is_damaged_png(file: Path) -> bool:
    """Whether a file begins as a PNG and does not go on as one to its end.

    Parameters
    ----------
    file : Path

    Raises
    ------
    OSError
        If it cannot be read.
    """
    content = memoryview(file.read_bytes())
    if content[: len(_SIGNATURE)] != _SIGNATURE:
        return False
    at, kind = len(_SIGNATURE), b""
    while kind != b"IEND":
        length = int.from_bytes(content[at : at + 4])
        end = at + _FRAME + length
        if end > len(content):
            return True
        kind = bytes(content[at + 4 : at + 8])
        if zlib.crc32(content[at + 4 : end - 4]) != int.from_bytes(content[end - 4 : end]):
            return True
        at = end
    return False
