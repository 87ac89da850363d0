"""``stylit-ref oracle``: check a port of the algorithm against test vectors."""

import argparse

from stylit_ref.cli.parser import Parser
from stylit_ref.errors import InputError


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command; its own commands and their options are the oracle's."""
    parser = commands.add_parser(
        "oracle",
        help="check a port of the algorithm against test vectors",
        description="Check a port of the algorithm against test vectors of every stage.",
    )
    try:
        from oracle.command import add_commands
    except ModuleNotFoundError as error:
        parser.add_argument("rest", nargs="...", help="not installed")
        parser.set_defaults(command=_refuse, missing=error)
        return
    own = parser.add_subparsers(required=True, metavar="{check,cases}")
    add_commands(own)
    for each in own.choices.values():
        each.set_defaults(parser=each)


def _refuse(options):
    raise InputError(f"the oracle cannot be loaded: {options.missing}")
