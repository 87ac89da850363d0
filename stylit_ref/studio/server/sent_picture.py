"""A picture on its way to a page, which is sent what has changed since the one before it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from stylit_ref.studio.engine.events import Picture
from stylit_ref.studio.server.protocol import changes_bytes, picture_bytes

TILE = 16
"""Pixels along a tile; a tile is sent whole."""

_MOST_CHANGED = 0.7
"""Share of the tiles from which on the whole picture is sent."""


@dataclass(frozen=True, eq=False)
class SentPicture:
    """A picture that the engine tells, as pages are sent it.

    A stroke changes few pixels, and a message of a whole picture takes a browser longer to receive
    than the engine to make.

    Attributes
    ----------
    picture : Picture
        Is kept, and must not change.
    """

    picture: Picture

    @cached_property
    def tiles(self) -> NDArray[np.uint8]:
        """(rows, columns, 16, 48) uint8: rows of tiles from above, 0 beyond the picture."""
        height, width = self.picture.image.shape[:2]
        rows, columns = -(-height // TILE), -(-width // TILE)
        padded = np.zeros((rows * TILE, columns * TILE, 3), np.uint8)
        padded[:height, :width] = self.picture.image
        return np.ascontiguousarray(padded.reshape(rows, TILE, columns, 3 * TILE).swapaxes(1, 2))

    def message(self, before: "SentPicture | None") -> bytes:
        """What a page is sent that has had the picture ``before`` last."""
        if before is None or before.picture.image.shape != self.picture.image.shape:
            return picture_bytes(self.picture)
        # Eight bytes at a time: a tile's row has 48.
        differ = self.tiles.view(np.uint64) != before.tiles.view(np.uint64)
        changed = differ.reshape(*differ.shape[:2], -1).any(axis=2)
        if changed.mean() > _MOST_CHANGED:
            return picture_bytes(self.picture)
        return changes_bytes(self.picture, changed, self.tiles[changed])
