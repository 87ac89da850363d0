"""Several painted frames: side by side they are one style, and patches come from any of them.

Patches that lie over the border between two are not kept out: they are as few as at any other
column.
"""

import argparse
from collections.abc import Sequence
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.frame_files import files_of_frame, pattern_of, side_of, why_missing
from stylit_ref.cli.shot_problems import ShotProblems
from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import is_there
from stylit_ref.files.disk.patterns import is_pattern
from stylit_ref.stylization.checks import size_text

Value = TypeVar("Value", bound=np.uint8 | np.uint16 | np.float32)


class Paintings(NamedTuple):
    """What was painted, and over which guides.

    Attributes
    ----------
    files : list of str
        One, or several painted frames.
    guides : list of list of str
        For every painting the file of each guide.
    keyframes : tuple of int
        Numbers of the frames of the shot that were painted, if there are several; empty where
        something else was painted.
    """

    files: list[str]
    guides: list[list[str]]
    keyframes: tuple[int, ...] = ()


def find_paintings(options: argparse.Namespace, problems: ShotProblems) -> Paintings:
    """The paintings that ``--style`` names, and their guides.

    Parameters
    ----------
    options : argparse.Namespace
        With ``--style``, ``--guide`` and ``--guide-layers``.
    problems : ShotProblems
        Is told what is missing, and the patterns of the files.

    Returns
    -------
    Paintings

    Raises
    ------
    InputError
        If there are several paintings, and a source has no placeholder.
    """
    sources = [source for source, _ in options.guide]
    if not _stands_for_many(options.style):
        problems.add_missing([options.style])
        return Paintings([options.style], [side_of(options, sources, problems)])
    style = pattern_of(options.style, "style")
    patterns, painted = [pattern_of(source, "guide") for source in sources], style.frames()
    missing = [] if painted else [why_missing(style, (), ())]
    for pattern in patterns:
        there = pattern.frames()
        if not set(painted).issubset(there):
            why = why_missing(pattern, there, painted)
            missing.append(why + ", which is painted" * bool(there))
    for sentence in missing:
        problems.add(sentence)
    guides = [
        files_of_frame(options, patterns, frame, problems) for frame in painted if not missing
    ]
    are_of_shot = len(painted) > 1 and all(source == target for source, target in options.guide)
    return Paintings(
        [style.path(frame) for frame in painted], guides, tuple(painted) if are_of_shot else ()
    )


def paintings_of(style: str) -> list[str]:
    """The files that ``--style`` names.

    Raises
    ------
    InputError
        If there is no file of such a name.
    """
    if not _stands_for_many(style):
        return [style]
    pattern = pattern_of(style, "style")
    painted = pattern.frames()
    if not painted:
        raise InputError(why_missing(pattern, (), ()))
    return [pattern.path(frame) for frame in painted]


def _stands_for_many(style: str) -> bool:
    return is_pattern(style) and not is_there(style)


def side_by_side(images: Sequence[NDArray[Value]], files: Sequence[str]) -> NDArray[Value]:
    """One image of several.

    Parameters
    ----------
    images : sequence of (H, W, n) arrays
    files : sequence of str
        Where they come from.

    Returns
    -------
    (H, W times their number, n) array

    Raises
    ------
    InputError
        If they differ in size, channels or type.
    """
    first = images[0]
    for image, file in zip(images, files, strict=True):
        if image.shape != first.shape or image.dtype != first.dtype:
            ways = ", ".join(
                f"{name} is {size_text(each.shape)} with {each.shape[2]} channels of {each.dtype}"
                for each, name in ((image, file), (first, files[0]))
            )
            raise InputError(f"{ways}; painted frames of one style must be alike")
    return np.hstack(images)
