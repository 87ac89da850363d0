"""``stylit-ref view``: pictures from places between the views of a RUN."""

import argparse
import sys
from collections.abc import Iterator
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.fade_option import add_fade
from stylit_ref.cli.finished import counted_frames, tell_finished
from stylit_ref.cli.frame_files import pattern_of
from stylit_ref.cli.parser import Parser
from stylit_ref.cli.places import path_of, place_of, places_along, step_of
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.files.animation_file import SUFFIX, check_animation_writable, write_animation
from stylit_ref.files.colour.profile import read_colour_profile
from stylit_ref.files.disk.paths import check_distinct
from stylit_ref.files.write_image import check_image_writable, write_image
from stylit_ref.machine.compilation import Specialization
from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.notes import note
from stylit_ref.views.interpolation.formulae.mean import WIDEST
from stylit_ref.views.interpolation.of_run import geometry_of, views_of_run
from stylit_ref.views.interpolation.view_interpolator import MODES, ViewInterpolator
from stylit_ref.views.interpolation.warm_up import kernels_of_views
from stylit_ref.views.run_folder import Run

_USAGE = "%(prog)s --from RUN (--at RIGHT,UP | --path 'RIGHT,UP ...') --output IMAGE [options]"

_DESCRIPTION = """\
Show what 'stylit-ref views --run RUN' has drawn from places between its views, without stylizing
anew. Places are degrees to the right and upwards from the middle of the grid. For instance:

  stylit-ref view --from build/run --at 2.5,1.25 --output picture.png
  stylit-ref view --from build/run --path '-5,0 5,0' --output turning.webp

The RUN must hold a mesh or positions, and cameras; or motion between all neighbours.
docs/how_to/views_between.md explains it."""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "view",
        help="show a finished grid of views from places between them",
        usage=_USAGE,
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    parser.add_argument(
        "--from", required=True, metavar="RUN", dest="run", help="what 'views --run' wrote"
    )
    places = parser.add_mutually_exclusive_group(required=True)
    places.add_argument(
        "--at", type=place_of, metavar="RIGHT,UP",
        help="a place, in degrees from the middle of the grid; write --at=-2.5,0 for the left",
    )  # fmt: skip
    places.add_argument(
        "--path", type=path_of, metavar="'RIGHT,UP ...'", help="or places in quotes, to move along"
    )
    parser.add_argument(
        "--output", "-o", required=True, metavar="IMAGE",
        help="the picture to write; of a path one .webp that moves, or a name in which %%04d, #### "
        "or $F4 is the number of the frame",
    )  # fmt: skip
    parser.add_argument(
        "--mode", choices=MODES, default="fade", metavar="NAME",
        help="how it is made: fade, limited, nnf, blend, image or linear (default %(default)s)",
    )  # fmt: skip
    add_fade(parser)
    parser.add_argument(
        "--step", type=step_of, default=0.25, metavar="DEGREES",
        help="how far a path goes from frame to frame (default %(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--fps", type=step_of, default=24.0, metavar="N",
        help="frames a second of a .webp that moves (default %(default)s)",
    )  # fmt: skip
    parser.add_argument("--quiet", action="store_true", help="print warnings and errors only")


def run(options: argparse.Namespace) -> None:
    """Open, look, write; all is checked before."""
    start = perf_counter()
    found = Run(options.run)
    with ProgressLine(options.quiet) as line:
        line.compile(lambda: _kernels(found))
        views = views_of_run(found, band=options.band)
        places = [options.at] if options.at else places_along(options.path, options.step)
        for place in places:
            views.grid.check(place)
        moves = bool(options.path) and options.output.lower().endswith(SUFFIX)
        outputs = _outputs(options, moves, len(places))
        check_distinct(outputs, found.files)
        channels = found.picture(0).shape[2:] or (1,)
        for output in outputs:
            if moves:
                check_animation_writable(output, channels[0])
            else:
                check_image_writable(output, channels[0])
        _note_fade(options, views)
        pictures = _pictures(views, places, options.mode, line)
        if moves:
            pictures = list(pictures)
            write_animation(options.output, pictures, round(1000 / options.fps))
        else:
            profile = read_colour_profile(found.folder / found.facts["frames"][0]["picture"])
            for output, picture in zip(outputs, pictures, strict=True):
                write_image(output, picture, profile=profile)
    if not options.quiet:
        _tell(options, outputs, len(places), picture if not moves else pictures[0], start)


def _kernels(run: Run) -> list[Specialization]:
    """Those that are compiled at the first call; none of a RUN that is refused anyway."""
    channels, width = run.style().shape[2], run.params.patch_width
    if channels > STYLE_LANES or width > WIDEST:
        return []
    return kernels_of_views(channels, width, geometry_of(run))


def _pictures(
    views: ViewInterpolator, places: list[tuple[float, float]], mode: str, line: ProgressLine
) -> Iterator[NDArray[np.uint8]]:
    for number, place in enumerate(places, 1):
        yield views.picture(place, mode)
        if len(places) > 1:
            line.tell(number / len(places), f"frame {number} of {len(places)}")


def _outputs(options: argparse.Namespace, moves: bool, count: int) -> list[str]:
    if options.at or moves:
        return [options.output]
    pattern = pattern_of(options.output, "output")
    return [pattern.path(number) for number in range(1, count + 1)]


def _note_fade(options: argparse.Namespace, views: ViewInterpolator) -> None:
    """Say how wide the fade is, in what places are counted in."""
    axes = views.grid.columns, views.grid.rows
    widths = [options.band * gap for axis in axes for gap in axis.gaps]
    if options.mode == "fade" and options.band:
        least, most = f"{min(widths):.3g}", f"{max(widths):.3g}"
        reach = least if least == most else f"{least} to {most}"
        note(
            f"where the closest view changes, frames fade into each other over {reach} "
            f"{axes[0].unit}; --fade makes that narrower"
        )


def _tell(options, outputs, count, picture, start):
    seconds = perf_counter() - start
    if options.at:
        tell_finished(options.output, picture, seconds)
    else:
        last = f" to {outputs[-1]}" if len(outputs) > 1 else ""
        print(
            f"wrote {counted_frames(count)}, {outputs[0]}{last}, in {seconds:.1f} s",
            file=sys.stderr,
        )
