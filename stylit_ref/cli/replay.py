"""``stylit-ref replay``: another style image through a saved nearest-neighbour field."""

import argparse
from time import perf_counter

from stylit_ref.cli.deep_images import holds_bits_of
from stylit_ref.cli.finished import tell_finished
from stylit_ref.cli.parameter_options import whole_number
from stylit_ref.cli.parser import Parser
from stylit_ref.cli.replay_frames import replay_frames
from stylit_ref.errors import InputError
from stylit_ref.files.colour.bit_depth import to_depth
from stylit_ref.files.colour.profile import note_another_profile, read_colour_profile
from stylit_ref.files.disk.paths import check_distinct
from stylit_ref.files.read_image import read_image, read_mask
from stylit_ref.files.realtime_field import RealtimeField, read_any_field
from stylit_ref.files.write_image import check_image_writable, write_image
from stylit_ref.realtime.replaying import replay_realtime
from stylit_ref.stylization.replaying import replay

_DESCRIPTION = """\
Make the picture of a run anew from another version of the painting: with other colours, more bits,
or enlarged. The run must have written with --nnf where every pixel came from. For instance:

  stylit-ref replay --nnf field.npy --style twice_as_large.exr --output large.exr

The file knows the patch width, the mask and the sizes of its run. Of what 'sequence' or 'views'
wrote with --run, all frames follow:

  stylit-ref replay --run build/run --style oil.png --output 'oil.%04d.png'"""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "replay",
        help="make the picture of a run anew from another version of the painting",
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    fields = parser.add_mutually_exclusive_group(required=True)
    fields.add_argument("--nnf", metavar="FILE.npy", help="what 'run --nnf' wrote")
    fields.add_argument(
        "--run", metavar="FOLDER", help="what 'sequence --run' or 'views --run' wrote"
    )
    parser.add_argument("--style", required=True, metavar="IMAGE", help="the painting to send")
    parser.add_argument(
        "--output", required=True, metavar="IMAGE",
        help="the picture to write; with --run a name in which %%04d, #### or $F4 is the number of "
        "the frame, or {view} its name",
    )  # fmt: skip
    parser.add_argument(
        "--mask", metavar="IMAGE",
        help="leave the pixels alone that are white here (default: those that the run left alone)",
    )  # fmt: skip
    parser.add_argument(
        "--fill", metavar="IMAGE", help="show this image there (default: transparent)"
    )
    parser.add_argument(
        "--patch-size", type=whole_number, metavar="N", dest="patch_width",
        help="patch width of the run (default: what the file says; 5 if it says nothing)",
    )  # fmt: skip
    parser.add_argument(
        "--scale", type=whole_number, metavar="N",
        help="how many times larger the style is (default: what the sizes say; 1 if the file does "
        "not say its style's)",
    )  # fmt: skip
    parser.add_argument("--quiet", action="store_true", help="print warnings and errors only")


def run(options: argparse.Namespace) -> None:
    """Read, vote, write."""
    if options.run:
        replay_frames(options)
        return
    start = perf_counter()
    style = read_image(options.style)
    field = read_any_field(options.nnf)
    mask = read_mask(options.mask) if options.mask else None
    fill = to_depth(read_image(options.fill), style.dtype) if options.fill else None
    check_distinct([options.output], [options.style, options.nnf, options.mask, options.fill])
    profile = read_colour_profile(options.style)
    if options.fill:
        note_another_profile(options.fill, profile)
    if isinstance(field, RealtimeField):
        _refuse_dense(options)
        image = replay_realtime(field, style)
    else:
        image = replay(
            field, style, patch_width=options.patch_width, scale=options.scale, mask=mask, fill=fill
        )
    check_image_writable(options.output, image.shape[2])
    holds_bits_of(style, options.output, image.shape[2])
    write_image(options.output, image, curve="srgb", profile=profile)
    if not options.quiet:
        tell_finished(options.output, image, perf_counter() - start)


def _refuse_dense(options):
    """Refuse what a sparse field knows itself, or has not."""
    for name in ("mask", "fill", "patch_width", "scale"):
        if getattr(options, name) is not None:
            raise InputError(
                f"is not for {options.nnf}, which is of --method realtime; leave it out",
                parameter=name,
            )
