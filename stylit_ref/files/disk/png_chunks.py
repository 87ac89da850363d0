"""Chunks of a PNG file that stand before its pixels.

OpenImageIO does not tell the primaries of a PNG file (``cHRM``), and always writes those of sRGB.
"""

import struct
import zlib
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path

_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def read_chunks(file: str | Path) -> dict[bytes, bytes]:
    """Contents of the chunks before the pixels, by name; empty if it is no PNG file.

    Parameters
    ----------
    file : str or Path

    Returns
    -------
    dict of bytes to bytes
        Up to the first chunk that is cut off.
    """
    found = {}
    with open(file, "rb") as stream:
        if stream.read(8) != _SIGNATURE:
            return found
        while len(head := stream.read(8)) == 8 and head[4:] != b"IDAT":
            size = int.from_bytes(head[:4], "big")
            if size >= 1 << 24:  # larger than any profile: a damaged file
                break
            found[head[4:]] = stream.read(size)
            stream.read(4)
    return found


def replace_chunks(
    file: str | Path, removed: Collection[bytes], added: Mapping[bytes, bytes]
) -> None:
    """Take chunks out of a PNG file, and put others behind its header.

    Parameters
    ----------
    file : str or Path
        A whole PNG file; it is written anew.
    removed : collection of bytes
        Names.
    added : mapping of bytes to bytes
        Contents by name.
    """
    whole = Path(file).read_bytes()
    header, *others = _pieces(whole)
    new = [
        struct.pack(">I", len(data)) + name + data + _checksum(name + data)
        for name, data in added.items()
    ]
    kept = [piece for piece in others if piece[4:8] not in removed]
    Path(file).write_bytes(b"".join([_SIGNATURE, header, *new, *kept]))


def _pieces(whole: bytes) -> Iterator[bytes]:
    """Every chunk with its length, name and checksum."""
    place = len(_SIGNATURE)
    while place < len(whole):
        end = place + 12 + int.from_bytes(whole[place : place + 4], "big")
        yield whole[place:end]
        place = end


def _checksum(data):
    return zlib.crc32(data).to_bytes(4, "big")
