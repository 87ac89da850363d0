"""``stylit-ref sequence``: stylize the frames of an animation so that they do not flicker."""

import argparse

from stylit_ref.cli.frame_files import find_fills, find_frames, find_masks, pattern_of
from stylit_ref.cli.guide_options import add_guide_options
from stylit_ref.cli.motion_in import add_motion_options, find_motion
from stylit_ref.cli.paintings import find_paintings
from stylit_ref.cli.parser import FRAMES, Parser
from stylit_ref.cli.shot_in import ShotFiles, Times
from stylit_ref.cli.shot_options import (
    add_other_outputs,
    add_shot_options,
    chosen_coherence,
    shot_params,
)
from stylit_ref.cli.shot_problems import ShotProblems
from stylit_ref.cli.stylize_shot import stylize_shot
from stylit_ref.views.keyframes import values_of_time
from stylit_ref.views.params import FAST_SEQUENCE, SEQUENCE, SEQUENTIAL

_USAGE = (
    "%(prog)s --style IMAGE --guide SOURCE FRAMES [--guide ...] [--motion FRAMES] --output FRAMES "
    "[options]"
)

_DESCRIPTION = """\
Stylize the frames of an animation. Motion vectors tell where each point was in the frame before,
and strokes move with it. For instance, with the passes of Blender:

  stylit-ref sequence --preset fast --style painted_sphere.png \\
      --guide sphere.exr 'shot/scene.%04d.exr' --guide-layers Combined,DiffDir,IndexOB \\
      --motion 'shot/scene.%04d.exr' --motion-convention blender \\
      --frames 1-100 --output 'out/scene.%04d.png' --work build/work

FRAMES is a name in quotes with %04d, #### or $F4 where the number of the frame stands; the folder
may have one too. Without --motion every frame is stylized by itself, and strokes flicker."""

_ALONE = (
    "each frame is stylized by itself, so strokes flicker; name the motion of the frames with "
    "--motion, and they move along"
)


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "sequence",
        help="stylize the frames of an animation so that they do not flicker",
        usage=_USAGE,
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    everyday = parser.add_argument_group("everyday options")
    everyday.add_argument(
        "--style", required=True, metavar="IMAGE",
        help="the painting; or 'painted.%%04d.png' for several painted frames, whose guides are "
        "SOURCE, with a number too",
    )  # fmt: skip
    add_guide_options(everyday, FRAMES, "of the frames")
    everyday.add_argument(
        "--frames", metavar="RANGE",
        help="frames to stylize: 1-100, every second one of them 1-100x2, and one more "
        "1-100x2,120 (default: all for which there are files)",
    )  # fmt: skip
    everyday.add_argument(
        "--output", required=True, metavar=FRAMES,
        help="the pictures to write; their suffix chooses the format (.png, .tif, .exr, ...)",
    )  # fmt: skip
    add_motion_options(everyday)
    everyday.add_argument(
        "--mask", metavar=FRAMES,
        help="leave the pixels of the frames alone that are white here: pictures are transparent "
        "there",
    )  # fmt: skip
    everyday.add_argument(
        "--fill", metavar=FRAMES,
        help="show these images there, or one IMAGE in all frames (default: transparent)",
    )  # fmt: skip
    add_shot_options(parser, everyday, SEQUENCE)
    add_other_outputs(parser, FRAMES, "'nnf.%%04d.npy'")


def run(options: argparse.Namespace) -> None:
    """Find the files of all frames, and stylize them."""
    params = shot_params(options)
    coherence = chosen_coherence(options, _coherence(options), "--motion")
    outputs = [
        pattern_of(text, name) if text else None
        for name, text in (("output", options.output), ("nnf", options.nnf))
    ]
    problems = ShotProblems()
    paintings, found = find_paintings(options, problems), find_frames(options, problems)
    motion = find_motion(options, found.frames, coherence.order, problems)
    masks = find_masks(options, found.frames, problems)
    fills = find_fills(options, found.frames, problems)
    problems.add_missing(path for side in paintings.guides for path in side)
    problems.refuse()
    digits = len(str(found.frames[-1]))
    files = ShotFiles(
        paintings.files,
        paintings.guides,
        [str(frame).zfill(digits) for frame in found.frames],
        found.guides,
        motion,
        problems,
        masks,
        fills,
        _times(found.frames, paintings.keyframes),
    )
    pictures, fields = (
        [pattern.path(frame) for frame in found.frames] if pattern else [] for pattern in outputs
    )
    stylize_shot(options, files, params, coherence, pictures, fields, _ALONE)


def _coherence(options):
    """What is taken without options of coherence; None without motion."""
    if not options.motion:
        return None
    follows = options.order in (None, SEQUENTIAL) and options.weight != 0
    is_fast = options.preset == "fast" and options.votes is None
    return FAST_SEQUENCE if follows and is_fast else SEQUENCE


def _times(frames, keyframes):
    """When frames and paintings are, if several frames of the shot were painted."""
    if not keyframes:
        return None
    return Times(*(values_of_time(each, keyframes) for each in (keyframes, frames)))
