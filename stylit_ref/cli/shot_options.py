"""Options that ``sequence`` and ``views`` share."""

import argparse
from dataclasses import fields, replace

from stylit_ref.cli.guide_options import add_encoding_option
from stylit_ref.cli.method_options import (
    add_method,
    add_parameters,
    add_preset,
    chosen_params,
    method_of,
    parameters_of,
)
from stylit_ref.cli.parameter_options import add_parameter, whole_number
from stylit_ref.cli.parser import Parser
from stylit_ref.errors import InputError
from stylit_ref.stylization.methods import METHODS
from stylit_ref.stylization.params import Params
from stylit_ref.views.params import SEQUENTIAL, Coherence

_SPELLED = {
    "weight": "--coherence",
    "form": "--coherence-form",
    "order": "--order",
    "following_votes": "--following-iters",
}
_EVERYDAY = ("uniformity",)


def add_shot_options(
    parser: Parser, everyday: argparse._ArgumentGroup, coherence: Coherence
) -> None:
    """Add them, behind the options that name files.

    Parameters
    ----------
    parser : Parser
    everyday : argparse._ArgumentGroup
        The one that names files.
    coherence : Coherence
        What is taken without options.
    """
    add_preset(everyday, METHODS)
    everyday.add_argument(
        "--work", metavar="FOLDER",
        help="keep what is done of each frame here: the same command then goes on where it was "
        "interrupted, and with other options does again only what depends on them (default: a "
        "temporary folder)",
    )  # fmt: skip
    add_parameters(everyday, _EVERYDAY)
    add_encoding_option(everyday)
    everyday.add_argument(
        "--seed", type=whole_number, default=0, metavar="N",
        help="another seed gives a variant, the same seed the same bytes (default %(default)s)",
    )  # fmt: skip
    everyday.add_argument("--quiet", action="store_true", help="print warnings and errors only")

    of_coherence = parser.add_argument_group("coherence")
    for each in fields(Coherence):
        add_parameter(of_coherence, each, getattr(coherence, each.name), _SPELLED[each.name])
    detail = parser.add_argument_group("the method in detail")
    add_method(detail, METHODS)
    add_parameters(detail, [each.name for each in parameters_of(*METHODS)], _EVERYDAY)
    machine = parser.add_argument_group("the machine")
    machine.add_argument(
        "--threads", type=whole_number, metavar="N", help="threads to use (default: all)"
    )
    machine.add_argument(
        "--scheduler", metavar="ADDRESS",
        help="have the workers of this Dask scheduler do the work: tcp://HOST:8786; all machines "
        "must know the files and the folder of --work by the same names",
    )  # fmt: skip


def add_other_outputs(parser: Parser, metavar: str, example: str) -> None:
    """Add the options that name what else can be written.

    Parameters
    ----------
    parser : Parser
    metavar, example : str
        What a name is called that stands for a file of each frame, and one.
    """
    others = parser.add_argument_group("other files to write")
    others.add_argument(
        "--nnf", metavar=metavar,
        help=f"write where every pixel came from, as {example}, for 'stylit-ref replay'",
    )  # fmt: skip
    others.add_argument(
        "--run", metavar="FOLDER",
        help="write all of it into a folder: pictures, where every pixel came from, motion, and "
        "what it was made of; 'stylit-ref replay' and viewers read it",
    )  # fmt: skip


def shot_params(options: argparse.Namespace) -> Params:
    """Parameters of the method that was chosen.

    Raises
    ------
    InputError
        As of :func:`~stylit_ref.cli.method_options.chosen_params`, and if the method makes single
        frames.
    """
    if method_of(options) == "realtime":
        raise InputError(
            "is realtime, which makes single frames: give each to 'stylit-ref run', with "
            "--warm-start from the one before",
            parameter="method",
        )
    return chosen_params(options)


def chosen_coherence(
    options: argparse.Namespace, default: Coherence | None, motion: str
) -> Coherence:
    """The coherence that the options ask for.

    Parameters
    ----------
    options : argparse.Namespace
    default : Coherence or None
        None where there is no motion; then every frame is stylized by itself, one after the other.
    motion : str
        What would tell the motion.

    Raises
    ------
    InputError
        If a value is out of range, or needs motion.
    """
    values = {each.name: getattr(options, each.name) for each in fields(Coherence)}
    given = {name: value for name, value in values.items() if value is not None}
    if default is not None:
        return replace(default, **given)
    for name in given:
        raise InputError(f"is of use with {motion} alone; leave it out", parameter=name)
    return Coherence(weight=0, order=SEQUENTIAL)
