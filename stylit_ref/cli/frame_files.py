"""The files of a sequence: for each frame, the guides that patterns name."""

import argparse
import os
from collections.abc import Sequence, Set
from typing import NamedTuple

from stylit_ref.cli.guide_options import files_of_side
from stylit_ref.cli.shot_problems import ShotProblems
from stylit_ref.errors import InputError
from stylit_ref.files.disk.frame_ranges import frames_of, range_text
from stylit_ref.files.disk.paths import is_there
from stylit_ref.files.disk.patterns import FramePattern, is_pattern


class FrameFiles(NamedTuple):
    """Frames and their files.

    Attributes
    ----------
    frames : tuple of int
        Their numbers, in ascending order.
    guides : list of list of str
        For every frame the file of each guide.
    """

    frames: tuple[int, ...]
    guides: list[list[str]]


def find_frames(options: argparse.Namespace, problems: ShotProblems) -> FrameFiles:
    """The frames that ``--frames`` names, or those on the disk, and their guides.

    Parameters
    ----------
    options : argparse.Namespace
        With ``--guide``, ``--guide-layers`` and ``--frames``.
    problems : ShotProblems
        Is told what is missing, and the patterns of the files.

    Returns
    -------
    FrameFiles

    Raises
    ------
    InputError
        If a target has no placeholder.
    """
    patterns = [pattern_of(target, "guide") for _, target in options.guide]
    found = [pattern.frames() for pattern in patterns]
    wanted = frames_of(options.frames) if options.frames else _all_between(set().union(*found))
    remedy = "" if options.frames else "; render what is missing, or choose frames with --frames"
    missing = [
        why_missing(pattern, there, wanted) + remedy * bool(there)
        for pattern, there in zip(patterns, found, strict=True)
        if not there or not set(wanted).issubset(there)
    ]
    for sentence in missing:
        problems.add(sentence)
    guides = [files_of_frame(options, patterns, frame, problems) for frame in wanted if not missing]
    return FrameFiles(tuple(wanted), guides)


def find_masks(
    options: argparse.Namespace, frames: Sequence[int], problems: ShotProblems
) -> list[str]:
    """The files of ``--mask``, one for each frame; none without the option.

    Raises
    ------
    InputError
        If it has no placeholder.
    """
    return _beside_frames(options.mask, "mask", frames, problems) if options.mask else []


def find_fills(
    options: argparse.Namespace, frames: Sequence[int], problems: ShotProblems
) -> list[str]:
    """The files of ``--fill``, one for each frame: the same one where it names one.

    Raises
    ------
    InputError
        If there is no ``--mask``.
    """
    if not options.fill:
        return []
    if not options.mask:
        raise InputError("needs a --mask that says which pixels to fill", parameter="fill")
    if is_pattern(options.fill):
        return _beside_frames(options.fill, "fill", frames, problems)
    problems.add_missing([options.fill])
    return [options.fill] * len(frames)


def _beside_frames(text, parameter, frames, problems):
    pattern = pattern_of(text, parameter)
    there = pattern.frames()
    if not set(frames).issubset(there):
        problems.add(why_missing(pattern, there, frames))
    files = [pattern.path(frame) for frame in frames]
    problems.patterns |= dict.fromkeys(files, pattern.text)
    return files


def files_of_frame(
    options: argparse.Namespace,
    patterns: Sequence[FramePattern],
    frame: int,
    problems: ShotProblems,
) -> list[str]:
    """The file of each guide of a frame, on one side of ``--guide``.

    Parameters
    ----------
    options : argparse.Namespace
        With ``--guide-layers``.
    patterns : sequence of FramePattern
        One for each ``--guide``.
    frame : int
    problems : ShotProblems
        Is told what is missing, and the patterns of the files.
    """
    files = side_of(options, [pattern.path(frame) for pattern in patterns], problems)
    problems.patterns |= {  # with the layer, or the image in a folder, behind the pattern
        path: pattern.text + path.removeprefix(pattern.path(frame))
        for path in files
        for pattern in patterns
        if path.startswith(pattern.path(frame))
    }
    return files


def side_of(options: argparse.Namespace, paths: Sequence[str], problems: ShotProblems) -> list[str]:
    """As :func:`files_of_side`, but what is missing is added to the problems."""
    try:
        return files_of_side(options, paths)
    except InputError as error:
        problems.add(error.sentence)
        return []


def pattern_of(text: str, parameter: str) -> FramePattern:
    """The pattern that an option names.

    Raises
    ------
    InputError
        If it has no placeholder.
    """
    refuse_star(text, parameter)
    if not is_pattern(text):
        raise InputError(
            f"{text}: names one file; write %04d, #### or $F4 where the number of the frame "
            "stands, and put the name in quotes",
            parameter=parameter,
        )
    return FramePattern(os.path.expanduser(text))  # no shell does that within quotes


def refuse_star(text: str, parameter: str) -> None:
    """Refuse a name with a star, unless a file has that very name.

    Raises
    ------
    InputError
    """
    if "*" in text and not is_there(text):
        raise InputError(
            f"{text}: has a star where the number of the frame stands; write %04d or #### for a "
            "number of four digits, or %d for one without leading zeros, and put the name in "
            "quotes",
            parameter=parameter,
        )


def _all_between(frames: Set[int]) -> list[int]:
    """A number that is missing among those on the disk is no choice, but a frame that failed."""
    return list(range(min(frames), max(frames) + 1)) if frames else []


def why_missing(pattern: FramePattern, there: Sequence[int], wanted: Sequence[int]) -> str:
    """The sentence on a pattern that has files ``there``, and not all that are wanted."""
    if not there:
        respelled = pattern.respelled()
        remedy = f"; there are files of {respelled}" if respelled else ""
        return f"{pattern.text}: there is no file of such a name{remedy}"
    return f"{pattern.text}: there is no file for {counted(sorted(set(wanted).difference(there)))}"


def counted(frames: Sequence[int]) -> str:
    """Frames as a message names them: ``frame 7``, ``frames 1-9x2``."""
    return f"{'frame' if len(frames) == 1 else 'frames'} {range_text(frames)}"
