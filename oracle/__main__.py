"""``python -m oracle``: check a port, print the folder of the cases, write a new version."""

import argparse
import signal
import sys

from oracle.command import add_commands, add_version, version_of
from stylit_ref.errors import InputError


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; returns the exit code.

    0 on success, 1 if a port differs, 2 if the input cannot be used, 130 if interrupted.
    """
    parser = argparse.ArgumentParser(
        prog="python -m oracle",
        description="Check a port of the algorithm against test vectors of every stage. To check a "
        "program, or a module with run_case, NumPy is enough.",
        allow_abbrev=False,
    )
    commands = parser.add_subparsers(required=True, metavar="{check,cases,make}")
    add_commands(commands)
    make = commands.add_parser(
        "make",
        help="write the cases of a version that is not yet published",
        description="Write the cases of a version that is not yet published.",
        allow_abbrev=False,
    )
    make.set_defaults(command=_make)
    add_version(make)
    options = parser.parse_args(arguments)
    try:
        return options.command(options)
    except InputError as error:
        flag = f"--{error.parameter} " if error.parameter else ""
        print(f"oracle: {flag}{error.sentence}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("oracle: interrupted; no half-written file is left", file=sys.stderr)
        return 130


def _make(options):
    from oracle.make import make_version  # imports the whole library

    make_version(version_of(options))
    return 0


if __name__ == "__main__":
    if signal.getsignal(signal.SIGTERM) is not signal.SIG_IGN:
        signal.signal(signal.SIGTERM, signal.default_int_handler)
    sys.exit(main())
