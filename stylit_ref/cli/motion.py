"""``stylit-ref motion check``: which convention the motion vectors of a shot follow."""

import argparse
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.frame_files import refuse_star, why_missing
from stylit_ref.cli.motion_in import check_convention
from stylit_ref.cli.parser import FRAMES, Parser
from stylit_ref.errors import InputError
from stylit_ref.files.colour.bit_depth import to_uint8_by_rows
from stylit_ref.files.disk.patterns import FramePattern, is_pattern
from stylit_ref.files.layers.names import SeveralLayersError
from stylit_ref.files.motion_file import read_vectors
from stylit_ref.files.picture import read_picture
from stylit_ref.views.motion.check import Verdict, check_motion
from stylit_ref.views.motion.conventions import AUTO
from stylit_ref.views.motion.samples import Sample

MOST_FRAMES = 8
"""How many files of vectors are looked at, evenly spread over the shot."""

_LUMA = np.float32([0.299, 0.587, 0.114])

_DESCRIPTION = """\
Find out what the motion vectors of a shot mean: which way is up, which channel comes first, and
whether they lead to the next frame or to the one before. Every convention is tried on the pictures.
The one along which they differ least is named, for --motion-convention. For instance:

  stylit-ref motion check --guide 'shot/beauty.%04d.exr' --motion 'shot/vector.%04d.exr'

or, for one pair of frames:

  stylit-ref motion check --guide a.png --guide b.png --motion a_to_b.flo

The exit code is 1 if nothing can be decided, as for a still shot."""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command and its own."""
    parser = commands.add_parser(
        "motion",
        help="find the convention of motion vectors",
        description="Find out what the motion vectors of a shot mean.",
    )
    own = parser.add_subparsers(required=True, metavar="{check}")
    check = own.add_parser("check", help="name the convention", description=_DESCRIPTION)
    check.set_defaults(command=run, parser=check)
    group = check.add_argument_group("options")
    group.add_argument(
        "--guide", required=True, action="append", metavar=FRAMES,
        help="pictures of the frames, 'shot/beauty.%%04d.exr', with :LAYER behind the name of a "
        "multilayer file; or repeat --guide for every frame",
    )  # fmt: skip
    group.add_argument(
        "--motion", required=True, action="append", metavar=FRAMES,
        help="vectors of the frames, 'shot/vector.%%04d.exr', or 'flow/%%02d_to_%%02d.flo' with a "
        "file for each pair; or repeat --motion for every frame",
    )  # fmt: skip
    group.add_argument(
        "--motion-convention", default=AUTO, metavar="NAME",
        help="refuse the vectors if they do not follow this convention (default auto: name it)",
    )  # fmt: skip


def run(options: argparse.Namespace) -> int:
    """Print what every convention leaves of the pictures' differences, and name the best."""
    wanted = options.motion_convention
    check_convention(wanted)
    verdict = check_motion(list(_samples(options.guide, options.motion)))
    for trial in verdict.trials:
        print(f"{trial.error:7.2f}  {trial.convention.name}")
    print(f"{verdict.still:7.2f}  without motion")
    if verdict.convention is None:
        print(f"undecided: {verdict.why}")
        return 1
    name = verdict.convention.name if wanted == AUTO else _confirmed(wanted, verdict)
    print(f"{name} explains the pictures{'; ' * bool(verdict.why)}{verdict.why}")
    return 0


def _confirmed(wanted: str, verdict: Verdict) -> str:
    """The name that the user gave, unless another explains the pictures better."""
    best = verdict.trials[0]
    errors = {trial.convention.name: trial.error for trial in verdict.trials}
    if wanted not in errors:
        raise InputError(
            f"{wanted} cannot be tried on these files; {best.convention.name} explains the "
            "pictures",
            parameter="motion_convention",
        )
    if wanted not in {convention.name for convention in verdict.alike}:
        raise InputError(
            f"{wanted} leaves a warping error of {errors[wanted]:.2f}, and {best.convention.name} "
            f"one of {best.error:.2f}; write {best.convention.name}",
            parameter="motion_convention",
        )
    return wanted


def _samples(guides: Sequence[str], motions: Sequence[str]) -> Iterator[Sample]:
    """What there is to look at."""
    for text in guides:
        refuse_star(text, "guide")
    for text in motions:
        refuse_star(text, "motion")
    if len(guides) > 1 or len(motions) > 1 or not is_pattern(guides[0]):
        yield from _of_files(guides, motions)
        return
    if not is_pattern(motions[0]):
        raise InputError(
            f"{motions[0]}: names one file, and --guide those of a shot; write %04d or #### where "
            "the number of the frame stands",
            parameter="motion",
        )
    pictures, vectors = FramePattern(guides[0]), FramePattern(motions[0])
    shown = _frames(pictures, "guide")
    if vectors.names_pairs:
        yield from _of_pairs(pictures, vectors, shown)
        return
    there = _frames(vectors, "motion")
    usable = [frame for frame in there if {frame - 1, frame + 1} & set(shown) and frame in shown]
    inner = [frame for frame in usable if {frame - 1, frame + 1} <= set(shown)]
    if not usable:
        raise InputError(
            f"{motions[0]}: no frame of it has a picture of its own and one beside it in "
            f"{guides[0]}; both patterns need files of neighbouring frames",
            parameter="motion",
        )
    for frame in _spread(inner or usable):
        own, path = _shown(pictures, frame), vectors.path(frame)
        near = [step for step in (1, -1) if frame + step in shown]
        yield Sample(
            path,
            read_vectors(path),
            {step: (own, _shown(pictures, frame + step)) for step in near},
        )


def _frames(pattern: FramePattern, parameter: str):
    """The frames that there are files of."""
    frames = pattern.frames()
    if not frames:
        raise InputError(why_missing(pattern, frames, ()), parameter=parameter)
    return frames


def _of_pairs(pictures: FramePattern, vectors: FramePattern, shown: Sequence[int]):
    """Files that name two frames."""
    pairs = [(frame, frame + 1) for frame in shown if frame + 1 in shown]
    if not pairs:
        raise InputError(
            f"{pictures.text}: there are no two neighbouring frames", parameter="guide"
        )
    for first, second in _spread(pairs):
        path = vectors.path_of_pair(first, second)
        yield _of_pair(path, _shown(pictures, first), _shown(pictures, second))


def _of_files(guides, motions):
    """Files that are named one by one."""
    if len(guides) == 2 and len(motions) == 1:
        yield _of_pair(motions[0], *map(_brightness, guides))
        return
    if len(guides) != len(motions) or len(guides) < 2:
        raise InputError(
            f"names {len(motions)} files of vectors for {len(guides)} pictures; name two pictures "
            "and the vectors between them, or vectors for each picture",
            parameter="motion",
        )
    shown = [_brightness(path) for path in guides]
    for number, path in enumerate(motions):
        near = [step for step in (1, -1) if 0 <= number + step < len(shown)]
        pictures = {step: (shown[number], shown[number + step]) for step in near}
        yield Sample(path, read_vectors(path), pictures)


def _of_pair(path, here, there):
    """Two frames: vectors of one direction may belong to either, and lead into the other."""
    vectors = read_vectors(path)
    pictures = {1: (here, there)}
    if len(vectors.pairs) == 1:
        pictures[-1] = there, here
    return Sample(path, vectors, pictures)


def _spread(chosen):
    stride = -(-len(chosen) // MOST_FRAMES)
    return chosen[::stride]


def _shown(pictures: FramePattern, frame: int) -> NDArray[np.float32]:
    """The brightness of a frame."""
    try:
        return _brightness(pictures.path(frame))
    except SeveralLayersError as error:
        raise SeveralLayersError(Path(pictures.text), error.best, error.names) from None


def _brightness(path) -> NDArray[np.float32]:
    picture = read_picture(path)
    curve = "srgb" if picture.is_light else "none"
    shown = to_uint8_by_rows(picture.pixels, picture.alpha_channel, curve).astype(np.float32)
    return shown[:, :, :3] @ _LUMA if shown.shape[2] >= 3 else shown[:, :, 0]
