"""``stylit-ref replay-texture``: other maps of the exemplars through saved coordinates."""

import argparse
from time import perf_counter

from stylit_ref.cli.deep_images import holds_bits_of
from stylit_ref.cli.finished import tell_finished
from stylit_ref.cli.parser import Parser
from stylit_ref.files.colour.profile import read_colour_profile
from stylit_ref.files.disk.paths import check_distinct
from stylit_ref.files.read_image import read_image
from stylit_ref.files.texture_field import read_texture_field
from stylit_ref.files.write_image import check_image_writable, write_image
from stylit_ref.texture.replaying import KINDS, replay_texture

_DESCRIPTION = """\
Make a texture anew of other maps of its exemplar: normals, heights, labels, more bits, or an
enlargement. The texture must have been written with --save-coordinates. For instance:

  stylit-ref replay-texture --coordinates texture.npy --exemplar pebbles_normals.png \\
      --kind normals --output texture_normals.png

A map may be a whole number of times as large as its exemplar; so is the picture then."""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "replay-texture",
        help="make a texture anew of other maps of its exemplar",
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    parser.add_argument(
        "--coordinates", required=True, metavar="FILE.npy",
        help="what 'texture --save-coordinates' wrote",
    )  # fmt: skip
    parser.add_argument(
        "--exemplar", required=True, action="append", metavar="IMAGE",
        help="a map of the exemplar; of several exemplars one each, in their order",
    )  # fmt: skip
    parser.add_argument("--output", required=True, metavar="IMAGE", help="the picture to write")
    parser.add_argument(
        "--kind", choices=KINDS, default=KINDS[0],
        help="what lies between two pixels of a map, where patches were deformed: colours and "
        "normals are blended, labels are not (default %(default)s)",
    )  # fmt: skip
    parser.add_argument("--quiet", action="store_true", help="print warnings and errors only")


def run(options: argparse.Namespace) -> None:
    """Read, replay, write."""
    start = perf_counter()
    field = read_texture_field(options.coordinates)
    maps = [read_image(path) for path in options.exemplar]
    check_distinct([options.output], [*options.exemplar, options.coordinates])
    image = replay_texture(field, maps, kind=options.kind)
    check_image_writable(options.output, image.shape[2])
    holds_bits_of(image, options.output, image.shape[2], "map")
    profile = read_colour_profile(options.exemplar[0])
    write_image(options.output, image, curve="srgb", profile=profile)
    if not options.quiet:
        tell_finished(options.output, image, perf_counter() - start)
