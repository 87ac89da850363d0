"""``stylit-ref replay``: another style image through a saved nearest-neighbour field."""

from stylit_ref.files.nnf_file import read_nnf
from stylit_ref.files.output_file import check_distinct
from stylit_ref.files.read_image import read_image
from stylit_ref.files.write_image import check_image_writable, write_image
from stylit_ref.stylization.params import Params
from stylit_ref.stylization.replaying import replay


def add_parser(commands):
    """Add the command."""
    parser = commands.add_parser(
        "replay",
        help="send another style image through a saved nearest-neighbour field",
        description="Vote another style image of the same size, or an enlargement, through a "
        "nearest-neighbour field saved by 'run --nnf', at the image's own bit depth.",
        allow_abbrev=False,
    )
    parser.set_defaults(command=run, parser=parser)
    parser.add_argument("--nnf", required=True, metavar="FILE.npy", help="nearest-neighbour field")
    parser.add_argument("--style", required=True, metavar="IMAGE", help="style image")
    parser.add_argument("--output", required=True, metavar="IMAGE", help="image to write")
    parser.add_argument(
        "--patch-size", type=int, default=Params().patch_width, dest="patch_width",
        help="patch width of the run (default %(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--scale", type=int, default=1, help="how many times larger the style is (default 1)"
    )


def run(options):
    """Read, vote, write."""
    style = read_image(options.style)
    nnf = read_nnf(options.nnf)
    check_distinct([options.output], [options.style, options.nnf])
    check_image_writable(options.output, style.shape[2])
    image = replay(nnf, style, patch_width=options.patch_width, scale=options.scale)
    write_image(options.output, image)
