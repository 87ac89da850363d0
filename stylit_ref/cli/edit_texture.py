"""``stylit-ref edit-texture``: paint a saved texture with an exemplar, or put a patch on it."""

import argparse
from dataclasses import fields, replace
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.finished import tell_finished
from stylit_ref.cli.parameter_options import add_parameter, whole_number
from stylit_ref.cli.parser import Parser
from stylit_ref.cli.positions import position_of
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.cli.texture_files import TextureFiles, add_other_files
from stylit_ref.cli.texture_images import fitted_to, read_sources
from stylit_ref.cli.texture_masks import read_mask_of
from stylit_ref.errors import InputError
from stylit_ref.files.texture_field import read_texture_field
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.texture.dragging import drag, drop
from stylit_ref.texture.overlay import overlay
from stylit_ref.texture.painting import paint
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession
from stylit_ref.texture.warm_up import kernels_of_editing

_USAGE = "%(prog)s --coordinates FILE.npy --exemplar IMAGE --output IMAGE [options]"

_DESCRIPTION = """\
Change a texture that was written with --save-coordinates. Paint a part of it with an exemplar,
which may be a new one; the part is filled at once, and the rest stays as it is:

  stylit-ref edit-texture --coordinates texture.npy --exemplar grass.png --exemplar gravel.png \\
      --paint stroke.png --output painted.png

Or put a patch of an exemplar where you want it; its border is cut so that it fits in:

  stylit-ref edit-texture --coordinates texture.npy --exemplar pebbles.png --patch 120,80 \\
      --drop-at 300,200 --output dropped.png

With --save-coordinates the result can be changed again."""

_EVERYDAY = ("radius",)
_OF_PAINTING = "iterations", "max_deformation", "candidates", "tries"
_OF_PATCHES = "max_jump", "exponent", "eta", "weighting", "second_pass", "gamma"

_DEFAULTS = TextureParams(radius=64, radius_step=0)
"""R stays what is asked for, however many iterations the texture has behind it."""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "edit-texture",
        help="paint a saved texture with an exemplar, or put a patch on it",
        usage=_USAGE,
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    everyday = parser.add_argument_group("everyday options")
    everyday.add_argument(
        "--coordinates", dest="start", required=True, metavar="FILE.npy",
        help="the texture: what 'texture --save-coordinates' wrote, or this command",
    )  # fmt: skip
    everyday.add_argument(
        "--exemplar", required=True, action="append", metavar="IMAGE",
        help="the exemplars of the texture, in their order, and then new ones; repeat --exemplar",
    )  # fmt: skip
    everyday.add_argument(
        "--from-exemplar", type=whole_number, dest="exemplar_number", metavar="N",
        help="which --exemplar to paint with or to take the patch from, 1 for the first (default: "
        "the last)",
    )  # fmt: skip
    everyday.add_argument("--output", required=True, metavar="IMAGE", help="the picture to write")
    _add_parameters(everyday, _EVERYDAY)
    everyday.add_argument("--quiet", action="store_true", help="print warnings and errors only")
    painting = parser.add_argument_group("paint")
    painting.add_argument(
        "--paint", metavar="MASK", help="fill what is white in this image, as large as the texture"
    )
    painting.add_argument(
        "--seed", type=whole_number, default=0, metavar="N",
        help="another seed fills it in another way (default %(default)s)",
    )  # fmt: skip
    _add_parameters(painting, _OF_PAINTING)
    patches = parser.add_argument_group("put a patch")
    patches.add_argument(
        "--patch", type=position_of, dest="source", metavar="X,Y",
        help="the middle of the patch in the exemplar, in pixels from its upper left corner",
    )  # fmt: skip
    patches.add_argument(
        "--drop-at", type=position_of, dest="place", metavar="X,Y",
        help="where in the texture the middle of the patch goes",
    )  # fmt: skip
    patches.add_argument(
        "--least-radius", type=whole_number, default=1, metavar="N",
        help="the patch reaches at least so far; seams of the texture that are nearer count for "
        "nothing (default %(default)s)",
    )  # fmt: skip
    _add_parameters(parser.add_argument_group("the method in detail"), _OF_PATCHES)
    add_other_files(parser.add_argument_group("other files to write"))
    machine = parser.add_argument_group("the machine")
    machine.add_argument(
        "--threads", type=whole_number, metavar="N", help="threads to use (default: all)"
    )


def run(options: argparse.Namespace) -> None:
    """Read, change, write; all is checked before the work starts."""
    began = perf_counter()
    _check_options(options)
    names = *_EVERYDAY, *_OF_PAINTING, *_OF_PATCHES
    given = {name: getattr(options, name) for name in names}
    params = replace(
        _DEFAULTS, **{name: value for name, value in given.items() if value is not None}
    )
    field = read_texture_field(options.start)
    sources = read_sources(options.exemplar)
    size = field.coordinates.shape[:2]
    if options.radius is None:
        params = fitted_to(params, sources)
    number = _number_of_exemplar(options)
    mask = _mask(options, size) if options.paint else None
    files = TextureFiles(options, sources, [*options.exemplar, options.start, options.paint])
    with ProgressLine(options.quiet) as line, using_threads(options.threads):
        line.compile(lambda: kernels_of_editing(params))
        session = TextureSession(
            [source.colours for source in sources], size, params, seed=options.seed, start=field
        )
        if mask is None:
            source = number, *options.source
            drop(session, drag(session, source, options.place, least_radius=options.least_radius))
        else:
            paint(session, mask, number, params.iterations)
        image = files.picture(session)
        files.write(image, session, lambda: overlay(session))
    if not options.quiet:
        tell_finished(options.output, image, perf_counter() - began, *files.others)


def _check_options(options):
    if bool(options.paint) == bool(options.source):
        how = "one of them, then the other in a second run" if options.paint else "one of them"
        raise InputError(f"--paint MASK and --patch X,Y: give {how}")
    if bool(options.source) != bool(options.place):
        lacking = "place" if options.source else "source"
        raise InputError("is needed, too: --patch says from where, --drop-at where to",
                         parameter=lacking)  # fmt: skip


def _number_of_exemplar(options):
    count, number = len(options.exemplar), options.exemplar_number
    if number is None:
        return count
    if not 1 <= number <= count:
        upto = f" to {count}, the number of exemplars" if count > 1 else ", for the one exemplar"
        raise InputError(f"is {number}; it must be 1{upto}", parameter="exemplar_number")
    return number


def _mask(options, size) -> NDArray[np.bool_]:
    mask = read_mask_of(options.paint, size, "the texture")
    if not mask.any():
        raise InputError(f"{options.paint}: has no white pixel; paint in white what to fill")
    return mask


def _add_parameters(group, names):
    for each in fields(TextureParams):
        if each.name in names:
            add_parameter(group, each, getattr(_DEFAULTS, each.name))
