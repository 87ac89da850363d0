"""A RUN: the folder of a finished shot, for viewers, and for ``replay`` with another style.

``run.json`` in it names all other files, with their digests; ``docs/run_folder.md`` describes it.
"""

import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.field import Field
from stylit_ref.files.motion_exr import read_written_motion
from stylit_ref.files.nnf_file import read_nnf
from stylit_ref.files.npy_file import read_arrays
from stylit_ref.files.read_image import read_uint8
from stylit_ref.stylization.params import Params
from stylit_ref.views.frames import Motion
from stylit_ref.views.mesh import Mesh
from stylit_ref.views.params import Coherence
from stylit_ref.views.positions import Positions

RUN_FILE = "run.json"
SCHEMA, VERSION = "stylit-ref run", 2
READ_VERSIONS = 1, VERSION
"""In version 1 motion is not compressed: a ``.npy`` file of two arrays."""

CONVENTION = (
    "motion: (x, y) in pixels, x to the right and y downwards; added to a pixel of the frame 'to', "
    "it leads to the same point in the frame 'other'"
)


class Run:
    """A RUN on the disk. Files are read when they are asked for, and checked by their digests.

    Parameters
    ----------
    folder : str or Path

    Attributes
    ----------
    folder : Path
    names : tuple of str
        What the frames are called.
    size : tuple of 2 int
        Rows and columns of every frame.
    grid : tuple of 2 int or None
        Rows and columns of a grid of views.
    cameras : tuple of dict or None
        Of every frame; None where it is not known.
    pairs : tuple of tuple of 2 int
        ``(to, other)``: there is motion from frame ``to`` into frame ``other``.
    params : Params
    coherence : Coherence
    seed : int
    facts : dict
        All of ``run.json``.

    Raises
    ------
    InputError
        If the folder is no RUN, or of a later version.
    """

    folder: Path
    names: tuple[str, ...]
    size: tuple[int, int]
    grid: tuple[int, int] | None
    cameras: tuple[dict[str, Any] | None, ...]
    pairs: tuple[tuple[int, int], ...]
    params: Params
    coherence: Coherence
    seed: int
    facts: dict[str, Any]

    def __init__(self, folder: str | Path) -> None:
        self.folder = Path(folder)
        file = self.folder / RUN_FILE
        try:
            self.facts = facts = json.loads(file.read_text(encoding="utf-8"))
        except FileNotFoundError:
            raise InputError(
                f"{folder}: is no RUN, since it holds no {RUN_FILE}; name the folder that a "
                "finished run has written"
            ) from None
        except OSError as error:
            raise InputError(f"{file}: cannot be read: {error.strerror}") from None
        except ValueError as error:
            raise InputError(f"{file}: is no JSON: {error}") from None
        if not isinstance(facts, dict) or facts.get("schema") != SCHEMA:
            raise InputError(f"{file}: is not that of a RUN of this program")
        if facts.get("version") not in READ_VERSIONS:
            raise InputError(
                f"{file}: is of version {facts.get('version')}, and this program reads versions "
                f"{' and '.join(map(str, READ_VERSIONS))}; update the program"
            )
        try:
            self.names = tuple(frame["name"] for frame in facts["frames"])
            self.cameras = tuple(frame["camera"] for frame in facts["frames"])
            self.size = _pair(facts["size"])
            self.grid = None if facts["grid"] is None else _pair(facts["grid"])
            self.pairs = tuple((int(edge["to"]), int(edge["other"])) for edge in facts["motion"])
            self.params = Params(**facts["params"])
            self.coherence = Coherence(**facts["coherence"])
            self.seed = int(facts["seed"])
        except (KeyError, TypeError, ValueError) as error:
            raise InputError(
                f"{file}: lacks facts of a RUN, or holds wrong ones: {error}"
            ) from None

    @property
    def has_masks(self) -> bool:
        """Whether frames have been left alone in places; pictures are transparent there."""
        return bool(self.facts.get("has_masks"))

    @property
    def files(self) -> list[Path]:
        """All files of the RUN that are there."""
        named = [self.folder / name for name in (RUN_FILE, *self.facts.get("digests", {}))]
        return [file for file in named if file.is_file()]

    def style(self) -> NDArray[np.uint8]:
        """The style, (H_A, W_A, n) uint8."""
        return self._image(self._fact("style"))

    def source_guides(self) -> list[NDArray[np.uint8]]:
        """The guides of the source, each (H_A, W_A, c) uint8."""
        return [self._image(file) for file in self._fact("source_guides")]

    def picture(self, frame: int) -> NDArray[np.uint8]:
        """The picture of a frame, (H_B, W_B, n) uint8.

        Raises
        ------
        InputError
            If there is no such frame, or its file is damaged.
        """
        return read_uint8(self._file(self._of_frame(frame, "picture")))

    def field(self, frame: int) -> Field:
        """The nearest-neighbour field of a frame.

        Raises
        ------
        InputError
            If there is no such frame, or its file is damaged.
        """
        return read_nnf(self._file(self._of_frame(frame, "nnf")))

    def motion(self, to: int, other: int) -> Motion:
        """The motion of a pair.

        Raises
        ------
        InputError
            If there is none, or its file is damaged.
        """
        if (to, other) not in self.pairs:
            raise InputError(
                f"{self.folder}: has no motion from frame {to} into frame {other}; its pairs are "
                f"{', '.join(map(str, self.pairs)) or 'none'}"
            )
        file = self._file(self._fact("motion", self.pairs.index((to, other)), "file"))
        if file.suffix == ".npy":
            return read_arrays(file, lambda field, rest: Motion(field, rest[0].astype(bool)))
        return Motion(*read_written_motion(file))

    def mesh(self) -> Mesh | None:
        """The mesh that the views show; None if the RUN has none.

        Raises
        ------
        InputError
            If its file is damaged.
        """
        if "mesh" not in self.facts:
            return None
        return read_arrays(
            self._file(self._fact("mesh")), lambda vertices, rest: Mesh(vertices, *rest)
        )

    def positions(self, frame: int) -> Positions | None:
        """Where the points of a frame lie in the scene; None if the RUN does not hold it.

        Raises
        ------
        InputError
            If there is no such frame, or its file is damaged.
        """
        if "positions" not in self._of_frame(frame):
            return None
        return read_arrays(
            self._file(self._of_frame(frame, "positions")),
            lambda points, rest: Positions(points, *rest),
        )

    def _of_frame(self, frame, *what):
        if not 0 <= frame < len(self.names):
            raise InputError(
                f"{self.folder}: has no frame {frame}; its frames are 0 to {len(self.names) - 1}"
            )
        return self._fact("frames", frame, *what)

    def _image(self, name):
        file = self._file(name)
        if file.suffix == ".npy":
            return read_arrays(file, lambda image, rest: image)
        return np.atleast_3d(read_uint8(file))

    def _fact(self, *path):
        fact = self.facts
        try:
            for step in path:
                fact = fact[step]
        except (KeyError, IndexError, TypeError):
            place = ", ".join(map(str, path))
            raise InputError(f"{self.folder / RUN_FILE}: has no entry {place}") from None
        return fact

    def _file(self, name):
        """A file of the RUN, which is as the run wrote it."""
        file = self.folder / name
        if not file.is_file():
            raise InputError(f"{file}: is missing; {RUN_FILE} names it")
        if digest_of(file) != self._fact("digests", name):
            raise InputError(
                f"{file}: is not what the run wrote, since its digest differs; restore it, or do "
                "the run again"
            )
        return file


def digest_of(file: Path) -> str:
    """The digest of a file, as ``run.json`` holds it."""
    with file.open("rb") as content:
        return hashlib.file_digest(content, "sha256").hexdigest()


def _pair(values):
    first, second = values
    return int(first), int(second)
