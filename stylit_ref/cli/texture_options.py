"""Options of ``texture``, and the parameters that they give."""

import argparse
from dataclasses import fields

from stylit_ref.cli.parameter_options import add_parameter, parsed, whole_number
from stylit_ref.cli.positions import size_of
from stylit_ref.cli.texture_files import add_other_files
from stylit_ref.errors import InputError
from stylit_ref.parameters import Number, Several
from stylit_ref.texture.params import TEXTURE_PRESETS, TextureParams

_EVERYDAY = "radius", "iterations"
"""Parameters that an artist tries first."""

_SHARES = Several(Number(0, 1), "share")


def add_texture_options(parser: argparse.ArgumentParser) -> None:
    """Add them."""
    everyday = parser.add_argument_group("everyday options")
    everyday.add_argument(
        "--exemplar", action="append", default=[], metavar="IMAGE",
        help="the image that the texture shall look like; repeat --exemplar for several",
    )  # fmt: skip
    everyday.add_argument(
        "--size", type=size_of, metavar="WxH",
        help="width and height of the texture in pixels (default: those of a map or of --start, if "
        "there is one)",
    )  # fmt: skip
    everyday.add_argument(
        "--output", required=True, metavar="IMAGE",
        help="the picture to write; its suffix chooses the format (.png, .tif, .exr, ...)",
    )  # fmt: skip
    everyday.add_argument(
        "--preset", choices=TEXTURE_PRESETS,
        help="paper: the settings of Lasram and Lefebvre; complete: smaller and smaller patches, "
        "of which more are compared (default: complete where a picture is completed or made to "
        "tile, else default)",
    )  # fmt: skip
    _add_parameters(everyday, lambda name: name in _EVERYDAY)
    everyday.add_argument(
        "--seed", type=whole_number, default=0, metavar="N",
        help="another seed gives a variant, the same seed the same bytes (default %(default)s)",
    )  # fmt: skip
    everyday.add_argument("--quiet", action="store_true", help="print warnings and errors only")
    everyday.add_argument(
        "--start", metavar="FILE.npy",
        help="go on with a texture that --save-coordinates wrote; --iterations counts those that "
        "it has",
    )  # fmt: skip
    _add_repairs(parser.add_argument_group("repair a picture"))
    _add_maps(parser.add_argument_group("say what goes where"))
    _add_parameters(
        parser.add_argument_group("the method in detail"), lambda name: name not in _EVERYDAY
    )
    add_other_files(parser.add_argument_group("other files to write"))
    machine = parser.add_argument_group("the machine")
    machine.add_argument(
        "--threads", type=whole_number, metavar="N", help="threads to use (default: all)"
    )
    machine.add_argument(
        "--keep-interrupted", action="store_true",
        help="let Ctrl-C end the work after the iteration that it comes in, and write the texture",
    )  # fmt: skip


def chosen_texture_params(options: argparse.Namespace) -> TextureParams:
    """Parameters of the options: a preset, and what is given beside it.

    Raises
    ------
    InputError
        If a value is out of range.
    """
    given = {each.name: getattr(options, each.name) for each in fields(TextureParams)}
    repairs = options.complete or options.tile_in_place
    preset = options.preset or ("complete" if repairs else "default")
    chosen = {name: value for name, value in given.items() if value is not None}
    return TextureParams.preset(preset, **chosen)


def check_options(options: argparse.Namespace) -> None:
    """Refuse options that do not go together.

    Raises
    ------
    InputError
    """
    if options.complete and options.tile_in_place:
        raise InputError("--complete and --tile-in-place: give one of them, then the other in a "
                         "second run")  # fmt: skip
    if options.complete and not options.mask:
        raise InputError("needs a --mask that says which pixels to fill", parameter="complete")
    for name in ("mask", "inverted_mask", "unlocked"):
        if getattr(options, name) and not options.complete:
            raise InputError("is for --complete IMAGE", parameter=name)
    if options.band is not None and not options.tile_in_place:
        raise InputError("is for --tile-in-place IMAGE", parameter="band")
    if options.complete or options.tile_in_place:
        for name in (
            "size",
            "labels",
            "shares",
            "guide_source",
            "guide_target",
            "start",
            "save_overlay",
        ):
            if getattr(options, name):
                task = "--complete" if options.complete else "--tile-in-place"
                raise InputError(f"cannot be given with {task}; leave it out", parameter=name)
        if options.tile_in_place and options.exemplar:
            raise InputError(
                "cannot be given with --tile-in-place, which takes patches of the picture itself",
                parameter="exemplar",
            )
        return
    if not options.exemplar:
        raise InputError("is needed: the image that the texture shall look like",
                         parameter="exemplar")  # fmt: skip
    if not (options.size or options.labels or options.guide_target or options.start):
        raise InputError("is needed: width and height of the texture, such as 1024x1024",
                         parameter="size")  # fmt: skip
    if bool(options.guide_source) != bool(options.guide_target):
        lacking = "guide_target" if options.guide_source else "guide_source"
        raise InputError("is needed, too: a guide has two sides", parameter=lacking)
    if options.guide_weight is not None and not options.guide_source:
        raise InputError("is for --guide-source and --guide-target", parameter="guide_weight")


def _add_repairs(group):
    group.add_argument(
        "--complete", metavar="IMAGE",
        help="fill the holes of this picture, from its known pixels or from every --exemplar",
    )  # fmt: skip
    group.add_argument("--mask", metavar="IMAGE", help="the holes are white here")
    group.add_argument("--inverted-mask", action="store_true", help="the holes are black in --mask")
    group.add_argument(
        "--unlocked",
        action="store_true",
        help="let known pixels change, too, as in the paper, and print how many did",
    )
    group.add_argument(
        "--tile-in-place", metavar="IMAGE",
        help="change this picture near its borders so that it tiles",
    )  # fmt: skip
    group.add_argument(
        "--band", type=whole_number, metavar="N",
        help="with --tile-in-place: pixels this far from the border or farther stay as they are "
        "(default: a quarter of the shorter side, at most 64)",
    )  # fmt: skip


def _add_maps(group):
    group.add_argument(
        "--labels", metavar="IMAGE",
        help="a map with a colour for each exemplar, in the order of their values: the first "
        "--exemplar goes where it is darkest",
    )  # fmt: skip
    group.add_argument(
        "--shares", type=parsed(_SHARES), metavar="X[,X...]",
        help="how much of the texture each --exemplar gets, such as 0.3,0.7",
    )  # fmt: skip
    group.add_argument(
        "--guide-source", action="append", default=[], metavar="IMAGE",
        help="a guide for the exemplar, as large as it; one for each --exemplar",
    )  # fmt: skip
    group.add_argument(
        "--guide-target", metavar="IMAGE", help="the guide that the texture shall follow"
    )


def _add_parameters(group, chosen):
    for each in fields(TextureParams):
        if chosen(each.name):
            add_parameter(group, each, each.default)
