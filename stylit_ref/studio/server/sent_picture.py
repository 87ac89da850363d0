"""A picture on its way to a page, which is sent what has changed since the one before it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from stylit_ref.studio.server.protocol import changes_bytes, picture_bytes

TILE = 16
"""Pixels along a tile; a tile is sent whole."""

_MOST_CHANGED = 0.7
"""Share of the tiles from which on the whole picture is sent."""


@dataclass(frozen=True, eq=False)
class SentPicture:
    """A picture, and what is told of it.

    A stroke changes few pixels, and a message of a whole picture takes a browser longer to receive
    than the engine to make.

    Attributes
    ----------
    which : str
        One of :data:`~stylit_ref.studio.server.protocol.PICTURES`.
    image : (h, w, 3) uint8
        Is kept, and must not change.
    serial : int
        That of the last paint in it.
    milliseconds : float
        How long it took.
    of : str
        Of a look: what was asked for.
    """

    which: str
    image: NDArray[np.uint8]
    serial: int
    milliseconds: float
    of: str = ""

    @cached_property
    def tiles(self) -> NDArray[np.uint8]:
        """(rows, columns, 16, 48) uint8: rows of tiles from above, 0 beyond the picture."""
        height, width = self.image.shape[:2]
        rows, columns = -(-height // TILE), -(-width // TILE)
        padded = np.zeros((rows * TILE, columns * TILE, 3), np.uint8)
        padded[:height, :width] = self.image
        return np.ascontiguousarray(padded.reshape(rows, TILE, columns, 3 * TILE).swapaxes(1, 2))

    def message(self, before: "SentPicture | None") -> bytes:
        """What a page is sent that has had the picture ``before`` last."""
        told = self.which, self.image, self.serial, self.milliseconds, self.of
        if before is None or before.image.shape != self.image.shape:
            return picture_bytes(*told)
        # Eight bytes at a time: a tile's row has 48.
        differ = self.tiles.view(np.uint64) != before.tiles.view(np.uint64)
        changed = differ.reshape(*differ.shape[:2], -1).any(axis=2)
        if changed.mean() > _MOST_CHANGED:
            return picture_bytes(*told)
        return changes_bytes(*told, changed, self.tiles[changed])
