"""Frames that are stylized together: views of a grid, or a sequence, and their motion."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from stylit_ref.views.frames import Motion


@dataclass(frozen=True)
class FrameSet:
    """Frames, what they are stylized from, and what only metrics see.

    Attributes
    ----------
    name : str
    style : (H_A, W_A, n) uint8
    source_guides : tuple of (H_A, W_A, c) uint8
    guides : tuple of tuple of (H, W, c) uint8
        Of every frame.
    edges : mapping from (int, int) to Motion
        Where the points of frame ``to`` appear in frame ``other``, by ``(to, other)``.
    renderings : (F, H, W, 3) uint8
        The frames as they were rendered; seen by metrics alone.
    ids : (F, H, W, n) uint8, optional
        A colour for each thing; seen by metrics alone.
    nearness : (F, H, W) uint8, optional
        The larger, the nearer; seen by metrics alone.
    """

    name: str
    style: np.ndarray
    source_guides: tuple[np.ndarray, ...]
    guides: tuple[tuple[np.ndarray, ...], ...]
    edges: Mapping[tuple[int, int], Motion]
    renderings: np.ndarray
    ids: np.ndarray | None = None
    nearness: np.ndarray | None = None

    @property
    def frames(self):
        """How many frames there are."""
        return len(self.guides)

    @property
    def size(self):
        """Width and height of a frame as text."""
        height, width = self.guides[0][0].shape[:2]
        return f"{width}x{height}"

    @property
    def pixels(self):
        """Pixels of all frames."""
        height, width = self.guides[0][0].shape[:2]
        return self.frames * height * width

    @cached_property
    def digest(self):
        """Identifies what methods see."""
        motion = (part for pair in sorted(self.edges) for part in self.edges[pair])
        guides = (guide for frame in self.guides for guide in frame)
        pairs = np.array(sorted(self.edges))
        return _digest((self.style, *self.source_guides, *guides, pairs, *motion))

    @cached_property
    def digest_of_ids(self):
        """Identifies what metrics see beside that."""
        seen = self.renderings, self.ids, self.nearness
        return _digest(part for part in seen if part is not None)


def _digest(arrays):
    digest = hashlib.sha256()
    for array in arrays:
        digest.update(f"{array.shape} {array.dtype}".encode())
        digest.update(np.ascontiguousarray(array))
    return digest.hexdigest()
