"""Options that name the motion between the frames of a sequence, and the files they lead to."""

import argparse
from collections.abc import Mapping, Sequence
from itertools import pairwise

from stylit_ref.cli.frame_files import counted, pattern_of, why_missing
from stylit_ref.cli.motion_files import MotionFiles, VectorsOfFrames, vectors_of_pairs
from stylit_ref.cli.parser import FRAMES
from stylit_ref.cli.shot_problems import ShotProblems
from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import is_there
from stylit_ref.files.disk.patterns import FramePattern
from stylit_ref.files.motion_file import look_at_vectors
from stylit_ref.notes import note
from stylit_ref.views.frames import sequence_pairs
from stylit_ref.views.motion.conventions import (
    AUTO,
    BEFORE,
    NEXT,
    PROGRAMS,
    convention_named,
    convention_of,
)
from stylit_ref.views.params import SEQUENTIAL

_BESIDE = "motion_depth", "motion_ids"

_NEEDED = "; --motion needs a file that leads from each frame to the one before it"
_OR_TURNED = "; files of one direction alone are turned around, if there is none of the other"
_TURNED = (
    "has files that all lead the same way; they are turned around for the other, which is less "
    "exact at silhouettes"
)


def add_motion_options(group: argparse._ArgumentGroup) -> None:
    """Add them."""
    group.add_argument(
        "--motion", metavar=FRAMES,
        help="motion vectors of the frames: 'shot/vector.%%04d.exr', or 'flow/%%02d_to_%%02d.flo' "
        "with a file for each pair; without them every frame is stylized by itself",
    )  # fmt: skip
    group.add_argument(
        "--motion-convention", default=AUTO, metavar="NAME",
        help=f"what the vectors mean: {', '.join(PROGRAMS)}, with changes such as flo-flip-y; auto "
        "takes what the names in the files say; 'stylit-ref motion check' finds it (default "
        "%(default)s)",
    )  # fmt: skip
    group.add_argument(
        "--depth", dest="motion_depth", metavar=FRAMES,
        help="depth of the frames in floating point, where farther is larger; it tells what hides "
        "what, and strokes beside a silhouette then move with what they belong to",
    )  # fmt: skip
    group.add_argument(
        "--ids",
        dest="motion_ids",
        metavar=FRAMES,
        help="IDs of the frames, or flat colours; no stroke moves from one thing to another",
    )


def find_motion(
    options: argparse.Namespace, frames: Sequence[int], order: str, problems: ShotProblems
) -> Mapping[tuple[int, int], MotionFiles]:
    """The files that tell the motion between neighbouring frames.

    Parameters
    ----------
    options : argparse.Namespace
    frames : sequence of int
        Their numbers, in ascending order.
    order : str
        Of :class:`stylit_ref.Coherence`; in a sequential one no frame heeds a later one.
    problems : ShotProblems
        Is told what is missing, and the patterns of the files.

    Returns
    -------
    dict
        By ``(to, other)``, places in ``frames``; empty without ``--motion``.

    Raises
    ------
    InputError
        If an option cannot be used.
    """
    if not options.motion:
        for name in ("motion_convention", *_BESIDE):
            if getattr(options, name) != options.parser.get_default(name):
                raise InputError("is of use with --motion alone; leave it out", parameter=name)
        return {}
    pattern = pattern_of(options.motion, "motion")
    check_convention(options.motion_convention)
    if len(frames) < 2:
        return {}
    beside = [_beside(options, name, frames, problems) for name in _BESIDE]
    pairs = [
        (to, other)
        for to, other in sequence_pairs(len(frames))
        if other < to or order != SEQUENTIAL
    ]
    find = _of_pairs if pattern.names_pairs else _of_frames
    found = find(pattern, frames, pairs, options.motion_convention, beside, problems)
    problems.know(found.values(), options.motion, *(getattr(options, name) for name in _BESIDE))
    return found


def _of_pairs(pattern: FramePattern, frames, pairs, convention, beside, problems):
    """Files that lead from one frame to another."""
    ways = {(to, other): _way(pattern, frames[to], frames[other]) for to, other in pairs}
    steps = [step for way in ways.values() for step in pairwise(way)]
    turned = _turned(pattern, steps)
    files = [pattern.path_of_pair(*(step[::-1] if step in turned else step)) for step in steps]
    if not pattern.count_files() and pattern.respelled():
        problems.add(why_missing(pattern, (), ()))
    elif not all(map(is_there, files)):
        ahead = any(first < last for first, last in steps)
        problems.add_missing(files, _NEEDED + " and to the one after it" * ahead + _OR_TURNED)
    elif turned:
        note(_TURNED, parameter="motion")
    return vectors_of_pairs(ways, pattern.path_of_pair, convention, *beside, turned)


def _turned(pattern: FramePattern, steps):
    """Steps of a direction in which no file leads, if files lead in the other.

    If some do, those that do not exist have been forgotten, and are missing.
    """
    turned = set()
    for is_ahead in (True, False):
        way = [step for step in steps if (step[0] < step[1]) == is_ahead]
        if not _any_leads(pattern, way) and _any_leads(pattern, (step[::-1] for step in way)):
            turned.update(way)
    return turned


def _any_leads(pattern: FramePattern, steps) -> bool:
    return any(is_there(pattern.path_of_pair(*step)) for step in steps)


def _way(pattern: FramePattern, first: int, last: int) -> Sequence[int]:
    """The two frames if a file leads between them, or else all that lie between as well.

    Where there is no file at all the first is what misses.
    """
    step = 1 if last > first else -1
    through = range(first, last + step, step)
    for turn in (1, -1):
        if _any_leads(pattern, [(first, last)[::turn]]):
            return first, last
        if _any_leads(pattern, (step[::turn] for step in pairwise(through))):
            return through
    return first, last


def check_convention(name: str) -> None:
    """Refuse a convention that ``--motion-convention`` cannot name.

    Raises
    ------
    InputError
    """
    if name == AUTO:
        return
    try:
        convention_named(name)
    except InputError as error:
        raise InputError(error.sentence, parameter="motion_convention") from None


def _of_frames(pattern: FramePattern, frames, pairs, convention, beside, problems):
    """Files of frames, for each pair those of the frames that its motion passes."""
    vectors, found = _passed(pattern, frames, convention, problems), {}
    for to, other in pairs:
        passed = range(min(frames[to], frames[other]), max(frames[to], frames[other]) + 1)
        of_frames, *others = (
            {frame: files[frame] for frame in passed if frame in files}
            for files in (vectors, *beside)
        )
        found[to, other] = VectorsOfFrames(
            frames[to], frames[other], of_frames, convention, *others
        )
    return found


def _passed(pattern: FramePattern, frames, convention, problems) -> dict[int, str]:
    """The files of all frames from the first to the last, those that are left out among them."""
    there = {frame: pattern.path(frame) for frame in pattern.frames()}
    if not there:
        problems.add(why_missing(pattern, (), ()))
        return {}
    try:
        steps = _steps(convention, next(iter(there.values())))
    except InputError as error:
        problems.add(error.sentence)
        return {}
    passed = range(frames[0], frames[-1] + 1)
    needed = passed[1:] if steps == {BEFORE} else passed[:-1] if steps == {NEXT} else passed
    missing = [frame for frame in needed if frame not in there]
    if missing:
        left_out = set(missing).isdisjoint(frames)
        why = "; the motion is followed through the frames that --frames leaves out" * left_out
        problems.add(f"{pattern.text}: there is no file for {counted(missing)}{why}")
    return {frame: there[frame] for frame in passed if frame in there}


def _steps(convention: str, first: str) -> set[int]:
    """Where vectors lead: to the next frame, to the one before, or to both."""
    if convention == AUTO:
        known = convention_of(look_at_vectors(first), first)
    else:
        known = convention_named(convention)
    return {lead.step for lead in known.leads}


def _beside(options, name, frames, problems) -> dict[int, str]:
    """The files of ``--depth`` or ``--ids``."""
    text = getattr(options, name)
    if not text:
        return {}
    pattern = pattern_of(text, name)
    there = pattern.frames()
    if not set(frames).issubset(there):
        problems.add(why_missing(pattern, there, frames))
        return {}
    return {frame: pattern.path(frame) for frame in there}
