"""What ``sequence`` and ``views`` read: a style, and a shot of files that fit together."""

import argparse
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.guide_options import guide_encoding
from stylit_ref.cli.motion_files import MotionFiles
from stylit_ref.cli.motion_look import check_motion_files
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.cli.scene_files import SceneFiles
from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import is_there
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.guides.remarks import GuideRemarks
from stylit_ref.files.guides.survey import GuideLook, look_at, read_source_guide
from stylit_ref.files.picture import read_picture
from stylit_ref.files.read_image import displayed
from stylit_ref.stylization.checks import check_source_guides, size_text
from stylit_ref.views.file_shot import FileShot

_SHOWN = 8
"""As many problems are named."""


class ShotFiles(NamedTuple):
    """The files of a shot.

    Attributes
    ----------
    style : str
    source_guides : sequence of str
    names : sequence of str
        What the frames are called.
    guides : sequence of sequence of str
        For every frame the file of each guide.
    motion : mapping from (int, int) to MotionFiles
        By ``(to, other)``.
    grid : tuple of 2 int, optional
        Rows and columns, if the frames are a grid of views, row by row.
    cameras : sequence of mapping, optional
        What is known of the camera of every frame.
    scene : SceneFiles, optional
        What the frames show.
    """

    style: str
    source_guides: Sequence[str]
    names: Sequence[str]
    guides: Sequence[Sequence[str]]
    motion: Mapping[tuple[int, int], MotionFiles]
    grid: tuple[int, int] | None = None
    cameras: Sequence[Mapping[str, Any]] | None = None
    scene: SceneFiles = SceneFiles()


class ShotIn(NamedTuple):
    """A shot that has been looked at.

    Attributes
    ----------
    style : (H_A, W_A, n) uint8
    deep_style : (H_A, W_A, n) uint16 or float32, or None
        The style as its file has it, where that is more than 8 bits.
    source_guides : tuple of (H_A, W_A, c) uint8
    shot : FileShot
    """

    style: NDArray[np.uint8]
    deep_style: NDArray[np.uint16 | np.float32] | None
    source_guides: tuple[NDArray[np.uint8], ...]
    shot: FileShot


def read_shot(options: argparse.Namespace, files: ShotFiles, line: ProgressLine) -> ShotIn:
    """Read style and source guides, look at every frame, and refuse what does not fit together.

    Parameters
    ----------
    options : argparse.Namespace
        With ``--guide-encoding``.
    files : ShotFiles
    line : ProgressLine
        Tells how many frames have been looked at.

    Returns
    -------
    ShotIn

    Raises
    ------
    InputError
        One for all frames.
    """
    picture = read_picture(files.style)
    style = displayed(files.style, picture)
    deep_style = None if picture.pixels.dtype == np.uint8 else picture.pixels
    encodings = _encodings(options, len(files.source_guides))
    looks = _look_at_all(files, encodings[0] == "auto", line)
    guides, chosen, remarks = [], [], GuideRemarks()
    for source, first, of_guide, encoding in zip(
        files.source_guides, files.guides[0], looks, encodings, strict=True
    ):
        guide, found = read_source_guide(source, first, of_guide, encoding, remarks)
        guides.append(guide)
        chosen.append(found)
    remarks.note()
    check_source_guides(style, guides, [f"--guide {source}" for source in files.source_guides])
    shot = FileShot(
        tuple(files.names),
        looks[0][1].size,
        tuple(map(tuple, files.guides)),
        tuple(chosen),
        tuple(guide.shape[2] for guide in guides),
        files.motion,
    )
    return ShotIn(style, deep_style, tuple(guides), shot)


def refuse_all(problems: Sequence[str]) -> None:
    """Refuse in one sentence whatever is wrong with a shot.

    Raises
    ------
    InputError
        If there are any problems.
    """
    if problems:
        more = len(problems) - _SHOWN
        others = f"; and {more} more" if more > 0 else ""
        raise InputError("; ".join(problems[:_SHOWN]) + others)


def missing_files(paths: Iterable[str]) -> list[str]:
    """A sentence that names those that do not exist; none if all do."""
    missing = [path for path in dict.fromkeys(paths) if not (is_there(path) or Path(path).is_dir())]
    if len(missing) > 1:
        more = f" and {len(missing) - _SHOWN} more" if len(missing) > _SHOWN else ""
        return [f"no such files: {', '.join(missing[:_SHOWN])}{more}"]
    return [f"{path}: no such file" for path in missing]


def _encodings(options, guides) -> Sequence[str] | Sequence[GuideEncoding]:
    chosen = guide_encoding(options)
    if isinstance(chosen, str):
        return [chosen] * guides
    if len(chosen) != guides:
        raise InputError(
            f"holds {len(chosen)} encodings for {guides} guides; each guide needs one",
            parameter="guide_encoding",
        )
    return chosen


def _look_at_all(files, needs_values, line) -> list[list[GuideLook]]:
    """For each guide a look at the source and at all frames."""
    sides, problems, looks = [files.source_guides, *files.guides], [], []
    for number, side in enumerate(sides):
        line.look(number, len(files.guides))
        for path in side:
            try:
                looks.append(look_at(path, needs_values=needs_values))
            except InputError as error:
                problems.append(str(error))
    guides = len(files.source_guides)
    by_guide = [looks[number::guides] for number in range(guides)]
    size = None if problems else by_guide[0][1].size
    if not problems:
        problems += _misfits(files, by_guide)
    refuse_all([*problems, *check_motion_files(files.motion.values(), size)])
    return by_guide


def _misfits(files, looks):
    """Frames of another size than the first, and with other colours than most."""
    first, size = files.guides[0][0], looks[0][1].size
    for frame, paths in enumerate(files.guides, 1):
        for path, of_guide in zip(paths, looks, strict=True):
            look = of_guide[frame]
            if look.size != size:
                said = "all frames must have the same size"
                yield f"{path}: is {size_text(look.size)} but {first} is {size_text(size)}; {said}"
            colours = max(each.colours for each in of_guide)
            if look.colours not in (1, colours):
                yield f"{path}: has {look.colours} channels, and others of this guide {colours}"
