"""``stylit-ref oracle``: check a port of the algorithm against test vectors."""

from stylit_ref.errors import InputError


def add_parser(commands):
    """Add the command."""
    oracle = commands.add_parser(
        "oracle",
        help="check a port of the algorithm against test vectors",
        description="Check a port of the algorithm against test vectors of every stage.",
        allow_abbrev=False,
    ).add_subparsers(required=True, metavar="check")
    parser = oracle.add_parser(
        "check",
        help="name the first stage, pixel and value that differ",
        description="Run a port on the cases and name the first stage, pixel and value that "
        "differ. Without one, this library's own passes are checked.",
        allow_abbrev=False,
    )
    parser.set_defaults(command=run, parser=parser)
    parser.add_argument(
        "--port", metavar="COMMAND",
        help="runs the port on the case in folder {input}, its results go to folder {output}",
    )  # fmt: skip
    parser.add_argument(
        "--module", metavar="NAME",
        help="Python module with run_case(stage, parameters, arrays), or with the passes",
    )  # fmt: skip
    parser.add_argument(
        "--timeout", type=float, metavar="SECONDS",
        help="longest that a --port may take for a case (default 60)",
    )  # fmt: skip
    parser.add_argument(
        "--jobs", type=int, default=1, metavar="N",
        help="processes that share the cases (default %(default)s)",
    )  # fmt: skip
    parser.add_argument("--stages", metavar="A,B", help="stages to check (default: all)")
    parser.add_argument(
        "--xfail", metavar="FILE", help="cases that must fail, a line each; * stands for anything"
    )
    parser.add_argument("--json", metavar="FILE", help="write what became of every case")
    parser.add_argument("--cases", metavar="v1", help="version of the cases (default: the newest)")


def run(options):
    """Check a port; the exit code is 1 where it differs."""
    try:
        from oracle.command import check_port
    except ModuleNotFoundError as error:
        raise InputError(f"the oracle cannot be loaded: {error}") from None
    return check_port(options)
