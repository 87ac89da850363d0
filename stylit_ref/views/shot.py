"""A shot: the frames of a sequence or the views of a grid, which are read when they are needed."""

import hashlib
from collections.abc import Sequence
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.stylization.checks import as_image, check_mask, size_text
from stylit_ref.views.frames import Edges, Motion, check_edges


@runtime_checkable
class Shot(Protocol):
    """What gives frames their guides and motion on demand; nothing of it is kept by the caller.

    A shot that other processes shall work on can be pickled, as one that holds paths.

    Attributes
    ----------
    names : sequence of str
        What each frame is called, all different.
    size : tuple of 2 int
        Rows and columns of every frame.
    pairs : sequence of tuple of 2 int
        ``(to, other)``: there is motion from frame ``to`` into frame ``other``, so that the picture
        of ``other`` can be shifted to ``to``.
    code : str
        A text that changes if the code does that makes guides and motion of what is read.
    """

    @property
    def names(self) -> Sequence[str]: ...

    @property
    def size(self) -> tuple[int, int]: ...

    @property
    def pairs(self) -> Sequence[tuple[int, int]]: ...

    @property
    def code(self) -> str: ...

    def guides(self, frame: int) -> Sequence[NDArray[np.uint8]]:
        """The guides of a frame, (H, W) or (H, W, c) uint8, in the order of the source's."""
        ...

    def motion(self, to: int, other: int) -> Motion:
        """The motion of a pair."""
        ...

    def mask(self, frame: int) -> NDArray[np.bool_] | None:
        """The pixels of a frame that are left alone, (H, W); None if none is."""
        ...

    def guides_digest(self, frame: int) -> str:
        """A text that changes if guides or mask of a frame do; it is quicker than reading them."""
        ...

    def motion_digest(self, to: int, other: int) -> str:
        """A text that changes if the motion of a pair does."""
        ...


class ArrayShot:
    """A shot in memory.

    Parameters
    ----------
    guides : sequence of sequences of (H, W) or (H, W, c) uint8
        The guides of every frame, all of one size.
    edges : mapping from (int, int) to Motion, optional
        The motion from frame ``to`` into frame ``other``, by ``(to, other)``. Without any, every
        frame is stylized by itself.
    names : sequence of str, optional
        By default their numbers, from 0.
    masks : sequence of ((H, W) bool or None), optional
        Of every frame the pixels that are left alone.

    Raises
    ------
    InputError
        If frames or motion differ in size; the message names the sizes.
    """

    names: tuple[str, ...]
    size: tuple[int, int]
    pairs: tuple[tuple[int, int], ...]
    code: str = ""

    def __init__(
        self,
        guides: Sequence[Sequence[NDArray[np.uint8]]],
        edges: Edges | None = None,
        names: Sequence[str] | None = None,
        masks: Sequence[NDArray[np.bool_] | None] | None = None,
    ) -> None:
        self._guides = [
            [as_image(guide, f"target_guides[{frame}][{k}]") for k, guide in enumerate(each)]
            for frame, each in enumerate(guides)
        ]
        if not self._guides or not all(self._guides):
            raise InputError(
                "is empty; at least one frame with one guide is needed", parameter="target_guides"
            )
        self.size = self._guides[0][0].shape[:2]
        for frame, each in enumerate(self._guides):
            if each[0].shape[:2] != self.size:
                raise InputError(
                    f"is {size_text(each[0].shape)} but frame 0 is {size_text(self.size)}; all "
                    "frames must have the same size",
                    parameter=f"target_guides[{frame}]",
                )
        self.names = tuple(map(str, range(len(self._guides)) if names is None else names))
        if len(set(self.names)) != len(self._guides):
            raise InputError(
                f"holds {len(set(self.names))} different names for {len(self._guides)} frames; "
                "each needs its own",
                parameter="names",
            )
        self._masks = [None] * len(self._guides) if masks is None else list(masks)
        if len(self._masks) != len(self._guides):
            raise InputError(
                f"holds {len(self._masks)} masks for {len(self._guides)} frames; each frame needs "
                "its own, or None",
                parameter="masks",
            )
        for mask in self._masks:
            if mask is not None:
                check_mask(mask, self.size)
        self._edges = check_edges(edges or {}, len(self._guides), self.size)
        self.pairs = tuple(self._edges)

    def guides(self, frame: int) -> Sequence[NDArray[np.uint8]]:
        """The guides of a frame, (H, W, c) uint8."""
        return self._guides[frame]

    def motion(self, to: int, other: int) -> Motion:
        """The motion of a pair."""
        return self._edges[to, other]

    def mask(self, frame: int) -> NDArray[np.bool_] | None:
        """The pixels of a frame that are left alone, (H, W) bool; None if none is."""
        return self._masks[frame]

    def guides_digest(self, frame: int) -> str:
        """A digest of the guides of a frame, and of its mask."""
        mask = self._masks[frame]
        return arrays_digest(*self._guides[frame], *([] if mask is None else [mask]))

    def motion_digest(self, to: int, other: int) -> str:
        """A digest of the motion of a pair."""
        return arrays_digest(*self._edges[to, other])


def arrays_digest(*arrays: NDArray[Any]) -> str:
    """A digest of arrays: their types, shapes and values."""
    digest = hashlib.sha256()
    for array in arrays:
        digest.update(f"{array.dtype.str} {array.shape} ".encode())
        digest.update(np.ascontiguousarray(array))
    return digest.hexdigest()
