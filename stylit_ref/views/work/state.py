"""What a frame is between two iterations, as arrays and as bytes."""

import hashlib
import struct
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

_DIGEST = hashlib.sha256().digest_size
_SIZES = struct.Struct("<4I")
"""Rows, columns, channels of the picture, and bytes of a coordinate."""


class State(NamedTuple):
    """A frame between two iterations.

    Attributes
    ----------
    nnf : (H, W, 2) int32
    picture : (H, W, n) uint8
        B', voted from the NNF.
    """

    nnf: NDArray[np.int32]
    picture: NDArray[np.uint8]

    @property
    def nbytes(self) -> int:
        """Bytes that both arrays take in memory."""
        return self.nnf.nbytes + self.picture.nbytes

    def to_bytes(self) -> bytes:
        """The state as a file holds it: a checksum, sizes, the NNF, and the picture.

        Coordinates take 2 bytes where they fit. Compression would take longer than it saves.
        """
        nnf = self.nnf
        if nnf.max(initial=0) <= np.iinfo(np.int16).max:
            nnf = nnf.astype(np.int16)
        sizes = _SIZES.pack(*self.picture.shape, nnf.itemsize)
        content = b"".join([sizes, _little_endian(nnf), self.picture.tobytes()])
        return hashlib.sha256(content).digest() + content

    @classmethod
    def from_bytes(cls, data: bytes) -> "State | None":
        """The state that :meth:`to_bytes` gave, or None if its checksum is wrong."""
        content = memoryview(data)[_DIGEST:]
        if hashlib.sha256(content).digest() != data[:_DIGEST]:
            return None
        height, width, channels, item = _SIZES.unpack_from(content)
        numbers = 2 * height * width
        nnf = np.frombuffer(content, f"<i{item}", numbers, _SIZES.size)
        picture = np.frombuffer(content, np.uint8, offset=_SIZES.size + numbers * item)
        return cls(
            nnf.astype(np.int32).reshape(height, width, 2),
            picture.copy().reshape(height, width, channels),
        )


def _little_endian(array):
    return array.astype(array.dtype.newbyteorder("<"), copy=False).tobytes()
