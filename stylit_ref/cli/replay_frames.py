"""``stylit-ref replay --run``: another style image through all frames of a RUN."""

import argparse
import sys
from collections.abc import Sequence
from time import perf_counter

from stylit_ref.cli.deep_images import holds_bits_of
from stylit_ref.cli.finished import counted_frames
from stylit_ref.cli.frame_files import pattern_of
from stylit_ref.cli.paintings import paintings_of, side_by_side
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.cli.views_manifest import VIEW
from stylit_ref.errors import InputError
from stylit_ref.files.colour.profile import read_colour_profile
from stylit_ref.files.disk.paths import check_distinct
from stylit_ref.files.read_image import read_image
from stylit_ref.files.write_image import check_image_writable, write_image
from stylit_ref.stylization.mask import filled_channels
from stylit_ref.views.replaying import replay_run
from stylit_ref.views.run_folder import Run

_OF_A_FIELD = "mask", "fill", "patch_width"


def replay_frames(options: argparse.Namespace) -> None:
    """Read, vote, write, frame by frame; all names are checked before.

    Raises
    ------
    InputError
        If the folder is no RUN, the style does not fit it, or a file cannot be written.
    """
    start = perf_counter()
    for name in _OF_A_FIELD:
        if getattr(options, name) is not None:
            raise InputError("is not for --run, which knows its own; leave it out", parameter=name)
    run, paintings = Run(options.run), paintings_of(options.style)
    style = side_by_side([read_image(painting) for painting in paintings], paintings)
    outputs = _outputs(options.output, run.names)
    check_distinct(outputs, [*paintings, *run.files])
    channels = style.shape[2]
    if run.has_masks:
        channels = filled_channels(channels, None)
    for output in outputs:
        check_image_writable(output, channels)
    holds_bits_of(style, outputs[0], channels)
    profile = read_colour_profile(paintings[0])
    with ProgressLine(options.quiet) as line:
        for done, replayed in enumerate(replay_run(run, style, scale=options.scale), 1):
            output = outputs[replayed.frame]
            write_image(output, replayed.image, curve="srgb", profile=profile)
            line.tell(done / len(outputs), f"frame {done} of {len(outputs)}")
            line.wrote(output, done, len(outputs))
    if not options.quiet:
        seconds = perf_counter() - start
        print(f"wrote {counted_frames(len(outputs))} in {seconds:.1f} s", file=sys.stderr)


def _outputs(text: str, names: Sequence[str]) -> list[str]:
    if VIEW in text:
        return [text.replace(VIEW, name) for name in names]
    pattern = pattern_of(text, "output")
    try:
        return [pattern.path(int(name)) for name in names]
    except ValueError:
        raise InputError(
            f"{text}: takes numbers, and the frames are called {', '.join(names[:3])}, ...; write "
            f"{VIEW} where the name of the view stands",
            parameter="output",
        ) from None
