"""``stylit-ref``: stylize images from the command line.

A command is a file with ``add_parser(commands)`` and ``run(options)``, and an entry of
:data:`COMMANDS`. Its parser's defaults are ``command``, which is ``run``, and ``parser``, which
knows the flag of a parameter that is refused. Nothing below knows the command line, so it alone may
call on the oracle, the bundled scenes and what there is for a GPU.
"""

import sys
import warnings

from stylit_ref import __version__
from stylit_ref.cli import doctor, example, oracle, replay, run
from stylit_ref.cli.parser import Parser
from stylit_ref.errors import InputError, one_line
from stylit_ref.machine.interruption import heed_interruptions
from stylit_ref.machine.threads import sleep_while_waiting

COMMANDS = run, replay, example, oracle, doctor


def command():
    """Entry point of ``stylit-ref``."""
    heed_interruptions()
    sleep_while_waiting()
    sys.exit(main())


def main(arguments: list[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments : list of str, optional
        Those of the process by default.

    Returns
    -------
    int
        Exit code: 0 on success, 1 where a port differs from the oracle, 2 for input that cannot
        be used, 130 when interrupted.
    """
    options = _parser().parse_args(arguments)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("always", UserWarning)
            warnings.showwarning = _note
            return options.command(options) or 0
    except InputError as error:
        name = f"{options.parser.flag_of(error.parameter)} " if error.parameter else ""
        print(f"stylit-ref: {name}{error.sentence}", file=sys.stderr)
        return 2
    except MemoryError:
        print("stylit-ref: there is not enough memory for images of this size", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("stylit-ref: interrupted; no half-written file is left", file=sys.stderr)
        return 130


def _parser():
    parser = Parser(
        prog="stylit-ref",
        description="Illumination-guided, example-based stylization of 3D renderings.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=f"stylit-ref {__version__}")
    commands = parser.add_subparsers(required=True)
    for each in COMMANDS:
        each.add_parser(commands)
    return parser


def _note(message, *_):
    print(f"note: {one_line(str(message))}", file=sys.stderr)
