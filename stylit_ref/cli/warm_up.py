"""``stylit-ref warm-up``: compile kernels before the first run."""

import argparse
import sys
from time import perf_counter

from stylit_ref.cli.method_options import (
    add_method,
    add_parameters,
    add_preset,
    chosen_params,
    method_of,
)
from stylit_ref.cli.methods import offer_of
from stylit_ref.cli.parameter_options import parsed
from stylit_ref.cli.parser import Parser
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.machine.compilation import compile_missing
from stylit_ref.stylization.params import Params
from stylit_ref.stylization.warm_up import GUIDE_CHANNELS, SIX_GUIDES, STYLE_CHANNELS
from stylit_ref.texture.warm_up import kernels_of_all_textures
from stylit_ref.views.params import SEQUENCE
from stylit_ref.views.warm_up import kernels_of_frames

_DESCRIPTION = """\
Compile kernels ahead and keep them on disk, so that the first picture, sequence and texture need
not wait for them. Runs of the same method, patch size and numbers of channels share them, whatever
the size of the images. Without options they are those of the picture that 'stylit-ref example'
leads to, and those of all textures."""

_COMMANDS = "run", "texture"

_COMPILED_FOR = (
    "patch_width", "vote_outliers", "schedule",
    "spacing", "mu", "scale_space", "means", "depth", "packing", "dense_finish",
)  # fmt: skip
"""Parameters that decide which kernels a run calls."""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "warm-up",
        help="compile the program now, so that the first run need not wait",
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    parser.add_argument(
        "--only", choices=_COMMANDS,
        help="compile for this command alone; run stands for 'sequence' and 'views' too (default: "
        "for all)",
    )  # fmt: skip
    add_method(parser)
    add_preset(parser)
    add_parameters(parser, _COMPILED_FOR)
    parser.add_argument(
        "--guide-channels", type=parsed(GUIDE_CHANNELS), default=SIX_GUIDES,
        metavar="N[,N...]",
        help="channels of each guide, 3 for one in colour (default: six in colour)",
    )  # fmt: skip
    parser.add_argument(
        "--style-channels", type=parsed(STYLE_CHANNELS), default=3, metavar="N",
        help="channels of the painting (default %(default)s)",
    )  # fmt: skip
    parser.add_argument("--quiet", action="store_true", help="print warnings and errors only")


def run(options: argparse.Namespace) -> None:
    """Compile, and say how much there was to do."""
    params, start = chosen_params(options), perf_counter()
    with ProgressLine(options.quiet) as line:
        needed = []
        if options.only != "texture":
            channels = options.style_channels, options.guide_channels
            needed += offer_of(method_of(options)).kernels(params, *channels)
            if isinstance(params, Params):
                needed += kernels_of_frames(params, SEQUENCE, *channels)
                needed = list(dict.fromkeys(needed))
        if options.only != "run":
            needed += kernels_of_all_textures()
        count = compile_missing(needed, line.compiling)
    if not options.quiet:
        seconds = perf_counter() - start
        print(f"compiled {count} of {len(needed)} kernels in {seconds:.1f} s", file=sys.stderr)
