"""``oracle check`` and ``oracle cases``, of ``stylit-ref`` and of ``python -m oracle``."""

import os
import sys
from contextlib import closing
from fnmatch import filter as matching
from pathlib import Path

from oracle.cases import damaged_files, read_cases
from oracle.check import check
from oracle.compare import FAILED, NOT_OFFERED, UNEXPECTED
from oracle.families import FAMILY_OF, NEWEST, folder_of, stages_of
from oracle.ports import TIMEOUT, CommandPort, ModulePort, import_port
from oracle.progress import progress
from oracle.report import summary, tell_failures, write_report
from stylit_ref.errors import InputError
from stylit_ref.files.output_file import check_distinct, check_writable


def add_commands(commands) -> None:
    """Add ``check`` and ``cases`` to a parser's commands.

    Parameters
    ----------
    commands : argparse._SubParsersAction
        What ``add_subparsers`` returns. Options of a command have its function as ``command``:
        ``options.command(options)`` runs it, returns the exit code, and raises InputError.
    """
    one = commands.add_parser(
        "check",
        help="name the first stage, pixel and value that differ",
        description="Run a port on the cases and name the first stage, pixel and value that "
        "differ. Without one, this library's own passes are checked.",
        allow_abbrev=False,
    )
    one.set_defaults(command=check_port)
    one.add_argument(
        "--port", metavar="COMMAND",
        help="runs the port on the case in folder {input}, its results go to folder {output}",
    )  # fmt: skip
    one.add_argument(
        "--module", metavar="NAME",
        help="Python module with run_case(stage, parameters, arrays), or with the passes",
    )  # fmt: skip
    one.add_argument(
        "--timeout", type=float, metavar="SECONDS",
        help=f"longest that a --port may take for a case (default {TIMEOUT})",
    )  # fmt: skip
    one.add_argument(
        "--jobs", type=int, default=1, metavar="N",
        help="processes that share the cases (default %(default)s)",
    )  # fmt: skip
    one.add_argument("--stages", metavar="A,B", help="stages to check (default: all)")
    one.add_argument(
        "--xfail", metavar="FILE", help="cases that must fail, a line each; * stands for anything"
    )
    one.add_argument("--json", metavar="FILE", help="write what became of every case")
    one.add_argument(
        "--cases", metavar="VERSION",
        help=f"{', '.join(FAMILY_OF)} (default {NEWEST})",
    )  # fmt: skip
    where = commands.add_parser(
        "cases",
        help="print the folder of the cases",
        description="Print the folder in which the cases of a version lie.",
        allow_abbrev=False,
    )
    where.set_defaults(command=print_folder)
    add_version(where)


def add_version(parser) -> None:
    """Add a version as an argument of its own."""
    parser.add_argument(
        "cases", nargs="?", metavar="VERSION", help=f"{', '.join(FAMILY_OF)} (default {NEWEST})"
    )


def version_of(options) -> str:
    """The version that the options name, or the newest.

    Raises
    ------
    InputError
        If there is none such.
    """
    version = NEWEST if options.cases is None else options.cases
    if version not in FAMILY_OF:
        raise InputError(f"there are no cases {version!r}; there are {', '.join(FAMILY_OF)}")
    return version


def print_folder(options) -> int:
    """Print where the cases of a version lie."""
    print(folder_of(version_of(options)))
    return 0


def check_port(options) -> int:
    """Check one port, or without one this library's own passes.

    Parameters
    ----------
    options : argparse.Namespace
        ``port``, ``module``, ``timeout``, ``jobs``, ``stages``, ``xfail``, ``json``, ``cases``.

    Returns
    -------
    int
        Exit code: 0 if all is as expected, otherwise 1.

    Raises
    ------
    InputError
        If the options name what is not there, or nothing was checked.
    """
    version = version_of(options)
    stages = _stages(options.stages, stages_of(version))
    for name, damage in damaged_files(version).items():
        raise InputError(f"{folder_of(version) / name}: {damage}")
    expected = _expected_failures(options.xfail, version)
    if options.json is not None:
        check_writable(options.json)
        check_distinct([options.json], [options.xfail])
    if options.jobs < 1:
        raise InputError(f"is {options.jobs}; it must be 1 or more", parameter="jobs")
    port = _port(options, version)

    total = sum(1 for _ in read_cases(version, stages))
    with closing(check(port, version, stages, expected, options.jobs)) as checked:
        outcomes = tell_failures(progress(checked, total))
    statuses = {outcome.status for outcome in outcomes}
    if statuses == {NOT_OFFERED}:
        raise InputError("nothing was checked: none of these stages is offered")
    print(summary(version, outcomes))
    code = int(not statuses.isdisjoint((FAILED, UNEXPECTED)))
    if options.json is not None:
        write_report(options.json, version, code, outcomes)
    return code


def _stages(text, known):
    """Stages of a list with commas, in the order of all; without a list all."""
    if text is None:
        return known
    wanted = [name.strip() for name in text.split(",")]
    for name in wanted:
        if name not in known:
            raise InputError(
                f"{name!r} is no stage; there are {', '.join(known)}", parameter="stages"
            )
    return [stage for stage in known if stage in wanted]


def _port(options, version):
    if options.port is not None:
        if options.module is not None:
            raise InputError("--port and --module exclude each other")
        timeout = TIMEOUT if options.timeout is None else options.timeout
        return CommandPort(options.port, timeout)
    if options.timeout is not None:
        raise InputError("--timeout is for a --port; a module is not stopped")
    sys.path.insert(0, os.getcwd())  # modules beside the reader, as for python -m
    if options.module is not None and hasattr(import_port(options.module), "run_case"):
        return ModulePort(options.module)
    return _passes_port(version, options.module)


def _passes_port(version, module):
    """Passes are checked within the library, which needs more than NumPy."""
    try:
        from oracle.stages.passes_port import PassesPort
    except ModuleNotFoundError as error:
        raise InputError(
            f"passes are checked within the library, which needs {error.name}: install stylit-ref "
            "with all that it needs, or name a --port or a --module with run_case"
        ) from None
    return PassesPort(version, module)


def _expected_failures(file, version):
    """Patterns of titles, one a line; what follows # is a remark."""
    if file is None:
        return set()
    try:
        lines = Path(file).read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is no text in UTF-8"
        raise InputError(f"{file}: cannot be read: {reason}") from None
    patterns = {line.partition("#")[0].strip() for line in lines} - {""}
    titles = [case.title for case in read_cases(version)]
    for pattern in sorted(patterns):
        if not matching(titles, pattern):
            raise InputError(f"{file}: {pattern!r} names no case; cases are named STAGE/NAME")
    return patterns
