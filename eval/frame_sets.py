"""Frames that are stylized together: views of a grid, or a sequence, and their motion."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.silhouettes import along_silhouettes, silhouettes_of


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
    depths : (F, H, W) float32, optional
        Farther is larger, 0 where nothing is.
    ids : (F, H, W, n) uint8, optional
        A colour for each thing; seen by metrics alone.
    """

    name: str
    style: np.ndarray
    source_guides: tuple[np.ndarray, ...]
    guides: tuple[tuple[np.ndarray, ...], ...]
    edges: Mapping[tuple[int, int], Motion]
    renderings: np.ndarray
    depths: np.ndarray | None = None
    ids: np.ndarray | None = None

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
    def edges_of_strokes(self):
        """The motion, where strokes beside silhouettes move with what they belong to.

        Without depths it is that of the surfaces, ``edges``.
        """
        if self.depths is None:
            return dict(self.edges)
        found = [silhouettes_of(depth) for depth in self.depths]
        return {
            (to, other): along_silhouettes(motion, found[to], found[other])
            for (to, other), motion in self.edges.items()
        }

    @cached_property
    def digest(self):
        """Identifies what methods see."""
        motion = (part for pair in sorted(self.edges) for part in self.edges[pair])
        guides = (guide for frame in self.guides for guide in frame)
        pairs = np.array(sorted(self.edges))
        depths = () if self.depths is None else (self.depths,)
        return _digest((self.style, *self.source_guides, *guides, pairs, *motion, *depths))

    @cached_property
    def digest_of_ids(self):
        """Identifies what metrics see beside that."""
        return _digest((self.renderings, *(() if self.ids is None else (self.ids,))))


def _digest(arrays):
    digest = hashlib.sha256()
    for array in arrays:
        digest.update(f"{array.shape} {array.dtype}".encode())
        digest.update(np.ascontiguousarray(array))
    return digest.hexdigest()
