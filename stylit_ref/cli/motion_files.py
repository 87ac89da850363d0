"""Files that tell the motion from one frame into another."""

from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import is_there
from stylit_ref.files.guides.encoding import labels_of
from stylit_ref.files.picture import read_picture
from stylit_ref.views.file_shot import files_digest
from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.between import motion_between
from stylit_ref.views.motion.conventions import FrameMotion
from stylit_ref.views.motion.reading import read_motion

Read = TypeVar("Read")

NO_IDS = (
    "{}: holds colours in floating point; IDs are whole numbers, or flat colours of 8 or 16 bits"
)
TWO_WAYS = (
    "{}: leads into the frame before and into the next, and stands for one pair of frames; write a "
    "file of its own for each direction"
)


@dataclass(frozen=True)
class VectorsOfFrames:
    """A file of vectors for each frame, from one frame to another.

    Attributes
    ----------
    to, other : int
        Numbers of the frames.
    vectors : mapping of int to str
        The files of these frames and of those between them, as far as there are any.
    convention : str
    depth, ids : mapping of int to str
        As ``vectors``.
    """

    to: int
    other: int
    vectors: Mapping[int, str]
    convention: str
    depth: Mapping[int, str]
    ids: Mapping[int, str]

    def read(self) -> Motion:
        """Read the motion.

        Raises
        ------
        InputError
            If a file cannot be read, or they do not tell the motion.
        """
        return motion_between(
            self.to,
            self.other,
            _reading(self.vectors, lambda path: read_motion(path, self.convention)),
            depth_of=_reading(self.depth, read_depth),
            labels_of=_reading(self.ids, read_ids),
        )

    def digest(self) -> str:
        """A text that changes if the motion does."""
        frames = [sorted(files) for files in (self.vectors, self.depth, self.ids)]
        return files_digest(self.files, repr((self.to, self.other, self.convention, frames)))

    @property
    def kinds(self) -> tuple[list[str], ...]:
        """Files of vectors, of depth, and of IDs."""
        named = self.vectors, self.depth, self.ids
        return tuple([files[frame] for frame in sorted(files)] for files in named)

    @property
    def files(self) -> list[str]:
        """All of them."""
        return [path for files in self.kinds for path in files]


@dataclass(frozen=True)
class VectorsOfPairs:
    """Files of vectors from one frame to another: a single one, or one for each step on the way.

    Attributes
    ----------
    ahead : tuple of (str or None)
        For each step the file that leads along it; None where only one leads back.
    back : tuple of (str or None)
        For each step the file that leads back, if there is one.
    convention : str
    depth, ids : mapping of int to str
        Of the frames on the way, from 0, as far as there are any.
    """

    ahead: tuple[str | None, ...]
    back: tuple[str | None, ...]
    convention: str
    depth: Mapping[int, str]
    ids: Mapping[int, str]

    def read(self) -> Motion:
        """Read the motion.

        Raises
        ------
        InputError
            If a file cannot be read, or leads into two frames.
        """
        return motion_between(
            0,
            len(self.ahead),
            self._vectors,
            depth_of=_reading(self.depth, read_depth),
            labels_of=_reading(self.ids, read_ids),
        )

    def digest(self) -> str:
        """A text that changes if the motion does."""
        leads = [[path is not None for path in way] for way in (self.ahead, self.back)]
        frames = [sorted(files) for files in (self.depth, self.ids)]
        return files_digest(self.files, repr((self.convention, leads, frames)))

    @property
    def kinds(self) -> tuple[list[str], ...]:
        """Files of vectors, of depth, and of IDs."""
        vectors = [path for path in (*self.ahead, *self.back) if path is not None]
        others = ([files[frame] for frame in sorted(files)] for files in (self.depth, self.ids))
        return vectors, *others

    @property
    def files(self) -> list[str]:
        """All of them."""
        return [path for files in self.kinds for path in files]

    def _vectors(self, frame):
        """Those of a frame on the way, ahead and back."""
        ahead, back = (
            FrameMotion(None, None) if path is None else _one_way(path, self.convention)
            for path in ((*self.ahead, None)[frame], (None, *self.back)[frame])
        )
        return FrameMotion(
            ahead.forward or ahead.backward, back.forward or back.backward, ahead.tells_visible
        )


MotionFiles = VectorsOfFrames | VectorsOfPairs
"""Where the motion of a pair of frames comes from."""


def vectors_of_pairs(
    ways: Mapping[tuple[int, int], Sequence[int]],
    path_of: Callable[[int, int], str],
    convention: str,
    depth: Mapping[int, str],
    ids: Mapping[int, str],
    turned: Set[tuple[int, int]] = frozenset(),
) -> dict[tuple[int, int], VectorsOfPairs]:
    """The files along ways from frame to frame; one that leads back helps to see what is hidden.

    Parameters
    ----------
    ways : mapping from (int, int) to sequence of int
        By pair, the frames from its first to its last.
    path_of : callable
        The file that leads from a frame to another.
    convention : str
    depth, ids : mappings of int to str
        By frame; empty where there are none.
    turned : set of (int, int)
        Steps that only files which lead back tell.

    Returns
    -------
    dict
        By the pair.
    """
    found = {}
    for pair, way in ways.items():
        steps = list(pairwise(way))
        backs = [path_of(after, frame) for frame, after in steps]
        beside = [
            {place: files[frame] for place, frame in enumerate(way) if frame in files}
            for files in (depth, ids)
        ]
        found[pair] = VectorsOfPairs(
            tuple(None if step in turned else path_of(*step) for step in steps),
            tuple(back if is_there(back) else None for back in backs),
            convention,
            *beside,
        )
    return found


def _one_way(path, convention):
    motion = read_motion(path, convention)
    if motion.forward and motion.backward:
        raise InputError(TWO_WAYS.format(path))
    return motion


def _reading(files: Mapping[int, str], read: Callable[[str], Read]) -> Callable[[int], Read | None]:
    """What gives the content of a frame's file, None where it has none.

    It remembers two frames: those that a step leads between are asked for again and again.
    """
    return lru_cache(maxsize=2)(lambda frame: read(files[frame]) if frame in files else None)


def read_depth(path: str) -> NDArray[np.float32]:
    """Read the distance of every pixel, (H, W).

    Raises
    ------
    InputError
        If it cannot be read, or is not floating point of one channel.
    """
    depth = read_picture(path, is_guide=True).colours
    if depth.dtype != np.float32 or depth.shape[2] > 1:
        raise InputError(no_depth(path, depth.shape[2], str(depth.dtype)))
    return depth[:, :, 0]


def no_depth(path: str, channels: int, kind: str) -> str:
    """Why a picture is no depth."""
    has = "one channel" if channels == 1 else f"{channels} channels"
    return (
        f"{path}: has {has} of {kind}; depth is one channel of floating point, and larger where it "
        "is farther: name a layer of an EXR, such as 'scene.exr:Depth' of Blender or "
        "'passes.exr:DEPTH' of make data"
    )


def read_ids(path: str) -> NDArray[np.int64]:
    """Read the ID of every pixel, (H, W); each colour of an image of integers is one.

    Raises
    ------
    InputError
        If it cannot be read, or holds colours in floating point.
    """
    picture = read_picture(path, is_guide=True)
    colours = picture.colours
    if colours.shape[2] == 1:
        return labels_of(picture)
    if colours.dtype == np.float32:
        raise InputError(NO_IDS.format(path))
    ids = np.zeros(colours.shape[:2], np.int64)
    for channel in range(colours.shape[2]):
        ids |= colours[:, :, channel].astype(np.int64) << 16 * channel
    return ids
