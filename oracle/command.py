"""The commands ``check`` and ``cases`` of ``stylit-ref oracle`` and ``python -m oracle``."""

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
from stylit_ref.files.disk.paths import check_distinct, check_writable


def add_commands(commands) -> None:
    """Add ``check`` and ``cases`` to a parser's commands.

    Parameters
    ----------
    commands : argparse._SubParsersAction
        The return value of ``add_subparsers``. To run the chosen command, call
        ``options.command(options)``: it returns the exit code or raises InputError.
    """
    one = commands.add_parser(
        "check",
        help="name the first stage, pixel and value that differ",
        description="Run a port on the cases and name the first stage, pixel and value that "
        "differ. Without --port and --module, the library's own passes are checked.",
        allow_abbrev=False,
    )
    one.set_defaults(command=check_port)
    one.add_argument(
        "--port", metavar="COMMAND",
        help="command that reads one case from the folder {input} and writes its results to the "
        "folder {output}",
    )  # fmt: skip
    one.add_argument(
        "--module", metavar="NAME",
        help="Python module that has run_case(stage, parameters, arrays), or some of the passes of "
        "stylit_ref.passes",
    )  # fmt: skip
    one.add_argument(
        "--timeout", type=float, metavar="SECONDS",
        help=f"longest time that the --port command may take for one case (default {TIMEOUT})",
    )  # fmt: skip
    one.add_argument(
        "--jobs", type=int, default=1, metavar="N",
        help="number of processes that share the cases (default %(default)s)",
    )  # fmt: skip
    one.add_argument(
        "--stages", metavar="A,B", help="check these stages only, commas between (default: all)"
    )
    one.add_argument(
        "--xfail", metavar="FILE",
        help="list of the cases that must fail, one STAGE/NAME a line; * stands for any text",
    )  # fmt: skip
    one.add_argument("--json", metavar="FILE", help="write the outcome of every case to FILE")
    one.add_argument(
        "--cases", metavar="VERSION",
        help=f"version of the cases: {', '.join(FAMILY_OF)} (default {NEWEST})",
    )  # fmt: skip
    where = commands.add_parser(
        "cases",
        help="print the folder of the cases",
        description="Print the folder that holds the cases of a version.",
        allow_abbrev=False,
    )
    where.set_defaults(command=print_folder)
    add_version(where)


def add_version(parser) -> None:
    """Add the version as a positional argument."""
    parser.add_argument(
        "cases", nargs="?", metavar="VERSION",
        help=f"version of the cases: {', '.join(FAMILY_OF)} (default {NEWEST})",
    )  # fmt: skip


def version_of(options) -> str:
    """The version that the options name, or the newest.

    Raises
    ------
    InputError
        If there is no such version.
    """
    version = NEWEST if options.cases is None else options.cases
    if version not in FAMILY_OF:
        raise InputError(
            f"there is no version {version!r} of the cases; choose one of: {', '.join(FAMILY_OF)}"
        )
    return version


def print_folder(options) -> int:
    """Print the folder of the cases of a version."""
    print(folder_of(version_of(options)))
    return 0


def check_port(options) -> int:
    """Check a port, or the library's own passes if the options name none.

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
        If an option cannot be used, or nothing was checked.
    """
    version = version_of(options)
    stages = _stages(options.stages, stages_of(version))
    for name, damage in damaged_files(version).items():
        raise InputError(f"{folder_of(version) / name}: {damage}; install stylit-ref again")
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
        raise InputError("nothing was checked: the port offers none of these stages")
    print(summary(version, outcomes))
    code = int(not statuses.isdisjoint((FAILED, UNEXPECTED)))
    if options.json is not None:
        write_report(options.json, version, code, outcomes)
    return code


def _stages(text, known):
    """The stages in a text with commas, or all stages if it is None; in the order of all."""
    if text is None:
        return known
    wanted = [name.strip() for name in text.split(",")]
    for name in wanted:
        if name not in known:
            others = [version for version in FAMILY_OF if name in stages_of(version)]
            remedy = f"write --cases {others[-1]}" if others else f"they are {', '.join(known)}"
            raise InputError(
                f"names {name!r}, which is not a stage of these cases; {remedy}",
                parameter="stages",
            )
    return [stage for stage in known if stage in wanted]


def _port(options, version):
    if options.port is not None:
        if options.module is not None:
            raise InputError("--port and --module cannot be used together; leave one out")
        timeout = TIMEOUT if options.timeout is None else options.timeout
        return CommandPort(options.port, timeout)
    if options.timeout is not None:
        raise InputError("--timeout needs --port; a module cannot be stopped")
    sys.path.insert(0, os.getcwd())  # finds modules in the working directory, as python -m does
    if options.module is not None and hasattr(import_port(options.module), "run_case"):
        return ModulePort(options.module)
    return _passes_port(version, options.module)


def _passes_port(version, module):
    """A port for a module of passes; to check one takes the whole library and its dependencies."""
    try:
        from oracle.stages.passes_port import PassesPort
    except ModuleNotFoundError as error:
        raise InputError(
            f"to check passes takes the package {error.name}, which is missing; install stylit-ref "
            "with its dependencies, or give a --port or a --module with run_case"
        ) from None
    return PassesPort(version, module)


def _expected_failures(file, version):
    """The patterns in a file, one a line; # begins a comment."""
    if file is None:
        return set()
    try:
        lines = Path(file).read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is not UTF-8 text"
        raise InputError(f"{file}: cannot be read: {reason}") from None
    patterns = {line.partition("#")[0].strip() for line in lines} - {""}
    titles = [case.title for case in read_cases(version)]
    for pattern in sorted(patterns):
        if not matching(titles, pattern):
            raise InputError(f"{file}: {pattern!r} matches no case; write STAGE/NAME")
    return patterns
