"""``stylit-ref``: stylize images from the command line.

A command is a file of that name with ``add_parser(commands)`` and ``run(options)``, and an entry of
:data:`COMMANDS`. Its parser's defaults are ``command``, which is ``run``, and ``parser``, which
knows the flag of a parameter that is refused. Only the command that is called is loaded, since all
of them together take longer to load than a preview takes to be made. Nothing below knows the
command line, so it alone may call on the oracle, the bundled scenes and what there is for a GPU.
"""

import sys
from collections.abc import Iterable
from importlib import import_module

from stylit_ref import __version__
from stylit_ref.cli.notes import notes_on_stderr
from stylit_ref.cli.parser import Parser
from stylit_ref.errors import InputError
from stylit_ref.machine.interruption import heed_interruptions
from stylit_ref.machine.threads import sleep_while_waiting

_DESCRIPTION = """\
Paint a sphere, and have a whole rendering in that style. Begin with

  stylit-ref example scenes

which copies scenes and prints a command that stylizes one. Or make a texture of any size from a
small picture of it:

  stylit-ref texture --exemplar pebbles.png --size 1024x1024 --output texture.png"""

COMMANDS = (
    "example",
    "run",
    "studio",
    "sequence",
    "views",
    "view",
    "viewer",
    "replay",
    "texture",
    "edit-texture",
    "replay-texture",
    "layers",
    "motion",
    "doctor",
    "warm-up",
    "oracle",
)
"""Names of the commands, in the order of the help."""


def command() -> None:
    """Run the command line in a process of its own."""
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
        Exit code: 0 on success, 1 where a port differs from the oracle or a check decides nothing,
        2 for input that cannot be used, 130 when interrupted.
    """
    words = sys.argv[1:] if arguments is None else arguments
    if not words:
        make_parser().print_help()
        return 2
    options = make_parser(words[:1] if words[0] in COMMANDS else COMMANDS).parse_args(words)
    try:
        with notes_on_stderr(options):
            return options.command(options) or 0
    except InputError as error:
        name = f"{options.parser.flag_of(error.parameter)} " if error.parameter else ""
        print(f"stylit-ref: {name}{error.sentence}", file=sys.stderr)
        return 2
    except MemoryError:
        print("stylit-ref: there is not enough memory for images of this size", file=sys.stderr)
        return 2
    except KeyboardInterrupt as error:
        left = str(error) or "no half-written file is left"
        print(f"stylit-ref: interrupted; {left}", file=sys.stderr)
        return 130


def make_parser(names: Iterable[str] = COMMANDS) -> Parser:
    """The parser of the command line, with those of some commands.

    Parameters
    ----------
    names : iterable of str
        Some of :data:`COMMANDS`.
    """
    parser = Parser(
        prog="stylit-ref",
        usage="%(prog)s COMMAND ...",
        description=_DESCRIPTION,
        epilog="stylit-ref COMMAND --help shows the options of a command.",
    )
    parser.add_argument("--version", action="version", version=f"stylit-ref {__version__}")
    commands = parser.add_subparsers(
        required=True, title="commands", metavar="COMMAND", prog="stylit-ref"
    )
    for name in names:
        import_module(f"{__name__}.{name.replace('-', '_')}").add_parser(commands)
    return parser
