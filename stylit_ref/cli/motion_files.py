"""Files that tell the motion from one frame into another."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import split_layer
from stylit_ref.files.guides.encoding import labels_of
from stylit_ref.files.layers.contents import contents_of
from stylit_ref.files.motion_flo import read_flo
from stylit_ref.files.picture import read_picture
from stylit_ref.stylization.checks import size_text
from stylit_ref.views.file_shot import files_digest
from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.between import motion_between
from stylit_ref.views.motion.conventions import FrameMotion
from stylit_ref.views.motion.reading import read_motion

Read = TypeVar("Read")

_TWO_WAYS = (
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
    def files(self) -> list[str]:
        """All of them."""
        named = self.vectors, self.depth, self.ids
        return [files[frame] for files in named for frame in sorted(files)]


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
    def files(self) -> list[str]:
        """All of them."""
        beside = *(self.depth or ()), *(self.ids or ())
        return [path for path in (self.ahead, self.back, *beside) if path]


MotionFiles = VectorsOfFrames | VectorsOfPair
"""Where the motion of a pair of frames comes from."""


def check_motion_files(motion: Iterable[MotionFiles], size: tuple[int, int]) -> list[str]:
    """What keeps motion from being used, before it is.

    Of all files the size is looked at, and the first pair is read whole.

    Parameters
    ----------
    motion : iterable of MotionFiles
    size : tuple of 2 int
        Rows and columns of the frames.

    Returns
    -------
    list of str
        A sentence each.
    """
    motion, problems = list(motion), []
    for path in dict.fromkeys(path for each in motion for path in each.files):
        try:
            found = _size_of(path)
        except InputError as error:
            problems.append(str(error))
            continue
        if found != size:
            problems.append(
                f"{path}: is {size_text(found)} but the frames are {size_text(size)}; all must "
                "have the same size"
            )
    if motion and not problems:
        motion[0].read()
    return problems


def _size_of(path):
    file, _ = split_layer(path)
    if file.suffix.lower() == ".flo":
        return read_flo(file).shape[:2]
    return contents_of(file).layers[0].size


def _one_way(path, convention):
    motion = read_motion(path, convention)
    if motion.forward and motion.backward:
        raise InputError(_TWO_WAYS.format(path))
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
        raise InputError(
            f"{path}: has {depth.shape[2]} channels of {depth.dtype}; depth is one channel of "
            "floating point"
        )
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
        raise InputError(
            f"{path}: holds colours in floating point; IDs are whole numbers, or flat colours of "
            "8 or 16 bits"
        )
    return colours.astype(np.int64) @ (1 << 16 * np.arange(colours.shape[2], dtype=np.int64))
