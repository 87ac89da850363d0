"""``stylit-ref run``: stylize a rendering by a painted example."""

import argparse
import logging
import sys
from time import perf_counter

from stylit_ref.cli.finished import tell_finished
from stylit_ref.cli.guide_options import add_encoding_option
from stylit_ref.cli.images_in import add_input_options, add_mask_options, read_images
from stylit_ref.cli.images_out import (
    add_other_outputs,
    add_output_option,
    check_outputs,
)
from stylit_ref.cli.method_options import (
    add_method,
    add_parameters,
    add_preset,
    chosen_params,
    method_of,
    parameters_of,
)
from stylit_ref.cli.methods import offer_of
from stylit_ref.cli.parameter_options import whole_number
from stylit_ref.cli.parser import Parser
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.machine.profiling import Profile
from stylit_ref.notes import note
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.stylization.backends import BACKENDS
from stylit_ref.stylization.methods import METHODS

_USAGE = "%(prog)s --style IMAGE --guide SOURCE TARGET [--guide ...] --output IMAGE [options]"

_DESCRIPTION = """\
Stylize a rendering as a painted example shows: you paint over the render of a simple scene, and the
picture of another scene follows. For instance, a preview:

  stylit-ref run --preset fast --style painted_sphere.png \\
      --guide sphere_full.png scene_full.png --guide sphere_shadow.png scene_shadow.png \\
      --output stylized.png

Or from two EXR files of Blender:

  stylit-ref run --preset fast --style painted_sphere.png \\
      --guide sphere.exr scene.exr --guide-layers Combined,DiffDir,IndexOB \\
      --output stylized.png

Images may be PNG, TIFF, JPEG, EXR and others; FILE.exr:LAYER names a layer of an EXR file."""

_EVERYDAY = ("uniformity",)
"""Parameters that an artist tries first."""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "run",
        help="stylize a rendering as a painted example shows",
        usage=_USAGE,
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    everyday = parser.add_argument_group("everyday options")
    add_input_options(everyday)
    add_output_option(everyday)
    add_preset(everyday)
    add_method(everyday)
    add_parameters(everyday, _EVERYDAY)
    add_encoding_option(everyday)
    add_mask_options(everyday)
    everyday.add_argument(
        "--seed", type=whole_number, default=0, metavar="N",
        help="another seed gives a variant, the same seed the same bytes (default %(default)s)",
    )  # fmt: skip
    everyday.add_argument("--quiet", action="store_true", help="print warnings and errors only")

    dense = [each.name for each in parameters_of(*METHODS)]
    add_parameters(parser.add_argument_group("the method in detail"), dense, _EVERYDAY)
    realtime = parser.add_argument_group("with --method realtime")
    add_parameters(realtime, without=dense)
    realtime.add_argument(
        "--warm-start", metavar="FILE.npy",
        help="begin with the matches of the frame before it, which --nnf wrote; search the finest "
        "level, and renew what has grown old from --renewal-level upwards",
    )  # fmt: skip
    add_other_outputs(parser.add_argument_group("other files to write"))
    machine = parser.add_argument_group("the machine")
    machine.add_argument(
        "--threads", type=whole_number, metavar="N", help="threads to use (default: all)"
    )
    machine.add_argument(
        "--backend", choices=BACKENDS, default="cpu", metavar="NAME",
        help=f"where to compute: {', '.join(BACKENDS)}; auto takes a GPU if there is one, cuda:... "
        "are other ways to use it, for measurements (default %(default)s)",
    )  # fmt: skip
    machine.add_argument(
        "--verbose", action="store_true",
        help="show the energy φ = δ + λρ beside the progress",
    )  # fmt: skip
    machine.add_argument("--profile", action="store_true", help="print where the time went")


def run(options: argparse.Namespace) -> None:
    """Read, stylize, write; all is checked before the work starts."""
    start = perf_counter()
    params, offer = chosen_params(options), offer_of(method_of(options))
    if isinstance(params, RealtimeParams):
        from stylit_ref.cli.realtime import run_realtime  # imported late: other methods need none

        run_realtime(options, params)
        return
    profile = Profile()
    with profile.stage("reading images"):
        images = read_images(options)
    outputs = check_outputs(options, params, images)
    if images.mask is not None and not images.mask.any():
        note("has no white pixel, so none is left alone", parameter="mask", level=logging.WARNING)
    held = images._asdict()
    del images  # so that nobody but the run holds what it can free
    with ProgressLine(options.quiet, options.verbose) as line:
        result = offer.run(
            held.pop("style"),
            held.pop("source_guides"),
            held.pop("target_guides"),
            params,
            seed=options.seed,
            mask=held["mask"],
            fill=held["fill"],
            backend=options.backend,
            threads=options.threads,
            compiling=line.compiling,
            progress=line.step,
            on_level=outputs.save_level,
            profile=profile,
        )
    with profile.stage("writing images"):
        outputs.write(result)
    if options.profile:
        print(*profile.table(), sep="\n", file=sys.stderr)
    if not options.quiet:
        others = filter(None, (options.nnf, options.save_levels))
        tell_finished(options.output, result.image, perf_counter() - start, *others)
