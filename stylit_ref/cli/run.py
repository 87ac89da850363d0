"""``stylit-ref run``: stylize a target as a style exemplar shows."""

import sys
import warnings
from functools import partial

from stylit_ref.cli.images_in import add_input_options, read_images
from stylit_ref.cli.images_out import (
    add_output_options,
    check_outputs,
    save_level,
    write_result,
)
from stylit_ref.cli.method_options import add_method_options, chosen_params
from stylit_ref.cli.methods import offer_of
from stylit_ref.cli.progress_line import progress_line
from stylit_ref.machine.profiling import Profile
from stylit_ref.stylization.backends import BACKENDS


def add_parser(commands):
    """Add the command."""
    parser = commands.add_parser(
        "run",
        help="stylize a target as a style exemplar shows",
        description="Stylize a target as a style exemplar shows. Images may be PNG, TIFF, JPEG, "
        "EXR and others; FILE.exr:LAYER names a layer of a multilayer EXR.",
        allow_abbrev=False,
    )
    parser.set_defaults(command=run, parser=parser)
    images = parser.add_argument_group("images")
    add_input_options(images)
    add_output_options(images)
    add_method_options(parser)
    parser.add_argument(
        "--backend", choices=BACKENDS, default="cpu",
        help="cpu; cuda for a GPU, cuda:shared_memory, cuda:live or cuda:live_sums for one of the "
        "thesis' other ways; auto for a GPU if there is one (default %(default)s)",
    )  # fmt: skip
    parser.add_argument("--threads", type=int, help="threads to use (default: all)")
    parser.add_argument("--quiet", action="store_true", help="no progress bar")
    parser.add_argument("--profile", action="store_true", help="print where the time went")


def run(options):
    """Read, stylize, write; all is checked before the work starts."""
    params = chosen_params(options)
    profile = Profile()
    with profile.stage("reading images"):
        images = read_images(options)
    check_outputs(options, params, images)
    if images.mask is not None and not images.mask.any():
        warnings.warn(f"{options.mask}: no pixel is white, so none is left alone", stacklevel=2)
    with progress_line(options.quiet) as show:
        result = offer_of(options.method).run(
            images.style,
            images.source_guides,
            images.target_guides,
            params,
            seed=options.seed,
            mask=images.mask,
            fill=images.fill,
            backend=options.backend,
            threads=options.threads,
            progress=show,
            on_level=partial(save_level, options),
            profile=profile,
        )
    with profile.stage("writing images"):
        write_result(options, result)
    if options.profile:
        print(*profile.table(), sep="\n", file=sys.stderr)
