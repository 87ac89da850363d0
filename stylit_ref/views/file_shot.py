"""A shot on the disk: paths, and how their values become guides and motion."""

import hashlib
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import split_layer
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.guides.read_guides import with_channels
from stylit_ref.files.picture import read_picture
from stylit_ref.files.read_image import read_mask
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.stylization.checks import check_mask, size_text
from stylit_ref.views.frames import Motion

_CHANGED = "one of its files has changed since the work began; give the command again"


class MotionSource(Protocol):
    """Where the motion of a pair comes from; it can be pickled."""

    def read(self) -> Motion:
        """Read the motion, (H, W, 2) float32 and (H, W) bool."""
        ...

    def digest(self) -> str:
        """A text that changes if the motion does (:func:`files_digest`)."""
        ...


@dataclass(frozen=True)
class FileShot:
    """A shot of files, which are read when a frame is worked on.

    A digest that was asked for is remembered, here and in copies for other processes. Whoever reads
    the frame later is refused if its files have changed since.

    Attributes
    ----------
    names : tuple of str
        What each frame is called, all different.
    size : tuple of 2 int
        Rows and columns of every frame.
    guide_files : tuple of tuple of str
        For every frame the file of each guide, with a layer as in
        :func:`stylit_ref.read_image`.
    encodings : tuple of GuideEncoding
        How each guide becomes 8 bits, in all frames and in the source alike.
    channels : tuple of int
        Channels of each guide of the source; grey is spread to as many, and alpha added.
    motion_sources : mapping from (int, int) to MotionSource
        By ``(to, other)``.
    mask_files : tuple of str
        For every frame the image that is white where the frame is left alone; empty without masks.
    times : tuple of int
        For every frame the value of the guide of time (:mod:`stylit_ref.views.keyframes`), which
        stands behind the others; empty without it.
    """

    names: tuple[str, ...]
    size: tuple[int, int]
    guide_files: tuple[tuple[str, ...], ...]
    encodings: tuple[GuideEncoding, ...]
    channels: tuple[int, ...]
    motion_sources: Mapping[tuple[int, int], MotionSource]
    mask_files: tuple[str, ...] = ()
    times: tuple[int, ...] = ()
    _told: dict[int | tuple[int, int], str] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    @property
    def pairs(self) -> Sequence[tuple[int, int]]:
        """The pairs with motion."""
        return tuple(self.motion_sources)

    @property
    def code(self) -> str:
        """A digest of the code that reads files: this module and those of the motion's sources."""
        sources = {type(source).__module__ for source in self.motion_sources.values()}
        return code_digest(__file__, *(sys.modules[name] for name in sorted(sources)))

    def guides(self, frame: int) -> Sequence[NDArray[np.uint8]]:
        """Read the guides of a frame.

        Raises
        ------
        InputError
            If a file cannot be read, has another size or other channels, or has changed.
        """
        files = zip(self.guide_files[frame], self.encodings, self.channels, strict=True)
        guides = [self._guide(*each) for each in files]
        guides += [np.full((*self.size, 1), time, np.uint8) for time in self._time(frame)]
        self._check_unchanged(frame)
        return guides

    def mask(self, frame: int) -> NDArray[np.bool_] | None:
        """Read the mask of a frame; None if there are none.

        Raises
        ------
        InputError
            If it cannot be read, has another size, covers the whole frame, or has changed.
        """
        if not self.mask_files:
            return None
        mask = read_mask(self.mask_files[frame])
        check_mask(mask, self.size)
        self._check_unchanged(frame)
        return mask

    def motion(self, to: int, other: int) -> Motion:
        """Read the motion of a pair.

        Raises
        ------
        InputError
            If a file cannot be read, or has changed.
        """
        source = self.motion_sources[to, other]
        motion, now = source.read(), source.digest()
        if self._told.get((to, other), now) != now:
            names = f"the motion from frame {self.names[to]} into frame {self.names[other]}"
            raise InputError(f"{names}: {_CHANGED}")
        return motion

    def guides_digest(self, frame: int) -> str:
        """A digest of the bytes of the files of a frame, and of how they are read."""
        self._told[frame] = self._digest_of_guides(frame)
        return self._told[frame]

    def motion_digest(self, to: int, other: int) -> str:
        """A digest of the motion of a pair."""
        self._told[to, other] = self.motion_sources[to, other].digest()
        return self._told[to, other]

    def _files(self, frame):
        return [*self.guide_files[frame], *self.mask_files[frame : frame + 1]]

    def _digest_of_guides(self, frame):
        facts = self.encodings, self.channels, *self._time(frame)
        return files_digest(self._files(frame), repr(facts))

    def _time(self, frame):
        return self.times[frame : frame + 1]

    def _check_unchanged(self, frame):
        now = self._digest_of_guides(frame)
        if self._told.get(frame, now) != now:
            files = ", ".join(dict.fromkeys(self._files(frame)))
            raise InputError(f"frame {self.names[frame]}: {_CHANGED} ({files})")

    def _guide(self, file, encoding, channels):
        picture = read_picture(file, is_guide=True)
        guide = encoding.encode(picture)
        if guide.shape[:2] != self.size:
            raise InputError(
                f"{file}: is {size_text(guide.shape)} but the other frames are "
                f"{size_text(self.size)}; all frames must have the same size"
            )
        has_alpha = picture.alpha_channel is not None
        wants_alpha = channels in (2, 4)
        guide = with_channels(
            guide, has_alpha=has_alpha, colours=channels - wants_alpha, wants_alpha=wants_alpha
        )
        if guide.shape[2] != channels:
            raise InputError(
                f"{file}: has {guide.shape[2]} channels but the source's guide has {channels}; "
                "save both with the same channels"
            )
        return guide


def files_digest(files: Sequence[str | Path], facts: str = "") -> str:
    """A digest of what files hold, wherever they lie.

    Parameters
    ----------
    files : sequence of str or Path
        With a layer as in :func:`stylit_ref.read_image`.
    facts : str
        How they are read.

    Returns
    -------
    str
    """
    digest = hashlib.sha256(facts.encode())
    for path in files:
        file, layer = split_layer(path)
        state = file.stat()
        content = _digest_of(file.absolute(), state.st_size, state.st_mtime_ns)
        digest.update(f" {layer} {content}".encode())
    return digest.hexdigest()


@lru_cache(maxsize=4096)
def _digest_of(file, size, changed):
    """Taken once of a file that does not change: all layers of a frame may be in one."""
    with file.open("rb") as content:
        return hashlib.file_digest(content, "sha256").hexdigest()
