"""The files of a RUN: what they are called, and which folder may become one."""

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path, PurePath
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import check_folder
from stylit_ref.files.disk.whole_file import write_text
from stylit_ref.views.run_folder import RUN_FILE, SCHEMA

UNFINISHED_FILE = "unfinished.json"
"""It stands in a RUN that is being written, and names its files."""


class RunFiles(NamedTuple):
    """Files of a RUN, by paths that begin at its folder.

    Attributes
    ----------
    style : str
    source_guides : tuple of str
    pictures, nnfs : tuple of str
        Of every frame.
    motion : mapping of (int, int) to str
        By ``(to, other)``.
    mesh : str
    positions : tuple of str
        Of every frame; a RUN has either a mesh or positions, or none of them.
    """

    style: str
    source_guides: tuple[str, ...]
    pictures: tuple[str, ...]
    nnfs: tuple[str, ...]
    motion: Mapping[tuple[int, int], str]
    mesh: str
    positions: tuple[str, ...]

    @property
    def names(self) -> list[str]:
        """All of them, and those that name them."""
        images = self.style, *self.source_guides, *self.pictures
        geometry = *self.motion.values(), self.mesh, *self.positions
        return [*images, *self.nnfs, *geometry, RUN_FILE, UNFINISHED_FILE]


def files_of_run(
    names: Sequence[str],
    pairs: Sequence[tuple[int, int]],
    style: NDArray[np.uint8],
    source_guides: Sequence[NDArray[np.uint8]],
) -> RunFiles:
    """What the files of a RUN are called.

    Parameters
    ----------
    names : sequence of str
        Of the frames.
    pairs : sequence of (int, int)
        Those with motion.
    style : (H_A, W_A, n) uint8
    source_guides : sequence of (H_A, W_A, c) uint8

    Returns
    -------
    RunFiles
    """
    names = _file_names(names)
    return RunFiles(
        _image("style", style),
        tuple(_image(f"source_guides/{k}", guide) for k, guide in enumerate(source_guides)),
        tuple(f"pictures/{name}.png" for name in names),
        tuple(f"nnfs/{name}.npy" for name in names),
        {(to, other): f"motion/{names[to]}_to_{names[other]}.exr" for to, other in pairs},
        "mesh.npy",
        tuple(f"positions/{name}.npy" for name in names),
    )


def files_to_replace(folder: str | Path) -> list[Path]:
    """The files of the RUN that a folder holds, finished or not.

    Parameters
    ----------
    folder : str or Path
        It need not exist.

    Returns
    -------
    list of Path
        Empty if the folder is.

    Raises
    ------
    InputError
        If it cannot be written, or holds something and is no RUN.
    """
    check_folder(folder)
    place, named = Path(folder), list[Path]()
    if not place.is_dir() or all(each.name.startswith(".") for each in place.iterdir()):
        return named
    told = [place / name for name in (RUN_FILE, UNFINISHED_FILE) if (place / name).is_file()]
    if not told:
        raise InputError(
            f"{folder}: holds other files than those of a RUN; name a new folder, or an empty one"
        )
    for file in told:
        named += [file, *(place / name for name in _named_by(file))]
    return named


def begin_run(folder: Path, files: RunFiles) -> None:
    """Make a folder ready for a RUN: remove the files of one that is there.

    Raises
    ------
    InputError
        As :func:`files_to_replace`.
    """
    old = [each for each in files_to_replace(folder) if each.name != UNFINISHED_FILE]
    listed = {*files.names, *(each.relative_to(folder).as_posix() for each in old)}
    facts = {"schema": SCHEMA, "digests": dict.fromkeys(sorted(listed))}
    write_text(folder / UNFINISHED_FILE, json.dumps(facts, indent=1) + "\n")
    for file in old:
        try:
            file.unlink(missing_ok=True)
        except OSError as error:
            raise InputError(f"{file}: cannot be removed: {error.strerror}") from None


def _named_by(file: Path) -> Iterator[str]:
    """The files that a RUN names, all within its folder."""
    refusal = InputError(f"{file}: is not that of a RUN; name another folder")
    try:
        facts = json.loads(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"{file}: cannot be read: {error.strerror}") from None
    except ValueError:
        raise refusal from None
    if not isinstance(facts, dict) or facts.get("schema") != SCHEMA:
        raise refusal
    names = facts.get("digests", {})
    for name in names:
        path = PurePath(name)
        if not path.is_absolute() and ".." not in path.parts:
            yield name


def _image(name, image):
    """PNG would divide colours by alpha."""
    return f"{name}.{'png' if image.shape[2] in (1, 3) else 'npy'}"


def _file_names(names):
    """The names as file names, or numbers if two would be the same."""
    cleaned = [re.sub(r"[^\w.-]", "_", name) for name in names]
    if len({name.lower() for name in cleaned}) == len(cleaned):
        return cleaned
    digits = len(str(len(names) - 1))
    return [f"{frame:0{digits}}" for frame in range(len(names))]
