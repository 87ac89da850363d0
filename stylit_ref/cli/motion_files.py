"""Files that tell the motion from one frame into another."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
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

NO_DEPTH = "{}: has {} channels of {}; depth is one channel of floating point"
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
class VectorsOfPair:
    """A file of vectors from one frame to another, and perhaps one back.

    Attributes
    ----------
    ahead : str
    back : str or None
    convention : str
    depth, ids : tuple of 2 str, or None
        Of both frames.
    """

    ahead: str
    back: str | None
    convention: str
    depth: tuple[str, str] | None = None
    ids: tuple[str, str] | None = None

    def read(self) -> Motion:
        """Read the motion.

        Raises
        ------
        InputError
            If a file cannot be read, or leads into two frames.
        """
        ahead = _one_way(self.ahead, self.convention)
        back = _one_way(self.back, self.convention) if self.back else FrameMotion(None, None)
        vectors = {
            0: FrameMotion(ahead.forward or ahead.backward, None, ahead.tells_visible),
            1: FrameMotion(None, back.forward or back.backward, back.tells_visible),
        }
        return motion_between(
            0,
            1,
            vectors.get,
            depth_of=_reading(dict(enumerate(self.depth or ())), read_depth),
            labels_of=_reading(dict(enumerate(self.ids or ())), read_ids),
        )

    def digest(self) -> str:
        """A text that changes if the motion does."""
        return files_digest(self.files, repr((self.convention, bool(self.back), bool(self.depth))))

    @property
    def kinds(self) -> tuple[list[str], ...]:
        """Files of vectors, of depth, and of IDs."""
        vectors = [self.ahead, self.back] if self.back else [self.ahead]
        return vectors, [*(self.depth or ())], [*(self.ids or ())]

    @property
    def files(self) -> list[str]:
        """All of them."""
        return [path for files in self.kinds for path in files]


MotionFiles = VectorsOfFrames | VectorsOfPair
"""Where the motion of a pair of frames comes from."""


def vectors_of_pairs(
    pairs: Iterable[tuple[int, int]],
    path_of: Callable[[int, int], str],
    convention: str,
    depth: Mapping[int, str],
    ids: Mapping[int, str],
) -> dict[tuple[int, int], VectorsOfPair]:
    """The files of pairs of frames; one that leads back helps to see what is hidden.

    Parameters
    ----------
    pairs : iterable of (int, int)
        Places of two frames.
    path_of : callable
        The file that leads from the frame of one place to that of another.
    convention : str
    depth, ids : mappings of int to str
        By the place of a frame; empty where there are none.

    Returns
    -------
    dict
        By the pair.
    """
    found = {}
    for to, other in pairs:
        back = path_of(other, to)
        beside = [(files[to], files[other]) if files else None for files in (depth, ids)]
        found[to, other] = VectorsOfPair(
            path_of(to, other), back if is_there(back) else None, convention, *beside
        )
    return found


def _one_way(path, convention):
    motion = read_motion(path, convention)
    if motion.forward and motion.backward:
        raise InputError(TWO_WAYS.format(path))
    return motion


def _reading(files: Mapping[int, str], read: Callable[[str], Read]) -> Callable[[int], Read | None]:
    """What gives the content of a frame's file, None where it has none."""
    return lambda frame: read(files[frame]) if frame in files else None


def read_depth(path: str) -> NDArray[np.float32]:
    """Read the distance of every pixel, (H, W).

    Raises
    ------
    InputError
        If it cannot be read, or is not floating point of one channel.
    """
    depth = read_picture(path, is_guide=True).colours
    if depth.dtype != np.float32 or depth.shape[2] > 1:
        raise InputError(NO_DEPTH.format(path, depth.shape[2], depth.dtype))
    return depth[:, :, 0]


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
    return colours.astype(np.int64) @ (1 << 16 * np.arange(colours.shape[2], dtype=np.int64))
