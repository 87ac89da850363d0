"""``stylit-ref replay``: another style image through a saved nearest-neighbour field."""

import argparse
from time import perf_counter

from stylit_ref.cli.finished import tell_finished
from stylit_ref.cli.parser import Parser
from stylit_ref.files.nnf_file import read_nnf
from stylit_ref.files.output_file import check_distinct
from stylit_ref.files.read_image import read_image
from stylit_ref.files.write_image import check_image_writable, write_image
from stylit_ref.stylization.params import Params
from stylit_ref.stylization.replaying import replay

_DESCRIPTION = """\
Make the picture of a run anew from another version of the painting: with other colours, more bits,
or enlarged. The run must have written with --nnf where every pixel came from. For instance:

  stylit-ref replay --nnf field.npy --style twice_as_large.exr --scale 2 --output large.exr"""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "replay",
        help="make the picture of a run anew from another version of the painting",
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    parser.add_argument("--nnf", required=True, metavar="FILE.npy", help="what 'run --nnf' wrote")
    parser.add_argument("--style", required=True, metavar="IMAGE", help="the painting to send")
    parser.add_argument("--output", required=True, metavar="IMAGE", help="the picture to write")
    parser.add_argument(
        "--patch-size", type=int, metavar="N", default=Params().patch_width, dest="patch_width",
        help="patch width of the run (default %(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--scale", type=int, default=1, metavar="N",
        help="how many times larger the style is (default %(default)s)",
    )  # fmt: skip
    parser.add_argument("--quiet", action="store_true", help="say nothing but what is wrong")


def run(options: argparse.Namespace) -> None:
    """Read, vote, write."""
    start = perf_counter()
    style = read_image(options.style)
    nnf = read_nnf(options.nnf)
    check_distinct([options.output], [options.style, options.nnf])
    check_image_writable(options.output, style.shape[2])
    image = replay(nnf, style, patch_width=options.patch_width, scale=options.scale)
    write_image(options.output, image)
    if not options.quiet:
        tell_finished(options.output, image, perf_counter() - start)
