"""What a frame is between two iterations, as arrays and as bytes."""

import hashlib
import io
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

_DIGEST = hashlib.sha256().digest_size


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
        """Bytes of both arrays."""
        return self.nnf.nbytes + self.picture.nbytes

    def to_bytes(self) -> bytes:
        """The state as a file holds it: a checksum, then both arrays as ``.npy``."""
        nnf = self.nnf
        if nnf.max(initial=0) <= np.iinfo(np.int16).max:
            nnf = nnf.astype(np.int16)
        content = io.BytesIO()
        content.write(bytes(_DIGEST))
        np.save(content, nnf)
        np.save(content, self.picture)
        data = content.getbuffer()
        data[:_DIGEST] = hashlib.sha256(data[_DIGEST:]).digest()
        return bytes(data)

    @classmethod
    def from_bytes(cls, data: bytes) -> "State | None":
        """The state that :meth:`to_bytes` gave, or None if its checksum is wrong."""
        if hashlib.sha256(data[_DIGEST:]).digest() != data[:_DIGEST]:
            return None
        content = io.BytesIO(data[_DIGEST:])
        return cls(np.load(content).astype(np.int32), np.load(content))
