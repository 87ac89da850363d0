"""``stylit-ref oracle check``: which stage a port gets wrong."""

import json
import sys
from collections import Counter
from contextlib import closing
from fnmatch import filter as matching
from pathlib import Path

from tqdm import tqdm

from oracle.cases import (
    NEWEST,
    STAGES,
    VERSIONS,
    damaged_files,
    folder_of,
    read_cases,
    spec_of,
)
from oracle.check import (
    FAILED,
    NOT_OFFERED,
    TIMEOUT,
    UNEXPECTED,
    CommandPort,
    ModulePort,
    check,
)
from stylit_ref import __version__
from stylit_ref.errors import InputError
from stylit_ref.files.output_file import check_distinct, check_writable, write_text


def check_port(options):
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
    version = NEWEST if options.cases is None else options.cases
    if version not in VERSIONS:
        raise InputError(f"there are no cases {version!r}; there are {', '.join(VERSIONS)}")
    stages = STAGES if options.stages is None else _stages(options.stages)
    for name, damage in damaged_files(version).items():
        raise InputError(f"{folder_of(version) / name}: {damage}")
    expected = _expected_failures(options.xfail, version)
    if options.json is not None:
        check_writable(options.json)
        check_distinct([options.json], [options.xfail])
    if options.jobs < 1:
        raise InputError(f"jobs is {options.jobs}; it must be 1 or more")
    port = _port(options)

    total = sum(1 for _ in read_cases(version, stages))
    outcomes = []
    with closing(check(port, version, stages, expected, options.jobs)) as checked:
        for outcome in tqdm(checked, total=total, unit="case", disable=None):
            outcomes.append(outcome)
            if outcome.status in (FAILED, UNEXPECTED):
                message = f": {outcome.difference.message}" if outcome.difference else ""
                tqdm.write(f"{outcome.title}: {outcome.status}{message}")
    counts = Counter(outcome.status for outcome in outcomes)
    if counts[NOT_OFFERED] == len(outcomes):
        raise InputError("nothing was checked: none of these stages is offered")
    print(", ".join(f"{count} {status}" for status, count in counts.items()))
    failed = next((outcome for outcome in outcomes if outcome.status == FAILED), None)
    if failed:
        print(f"Begin with stage {failed.stage}: section {failed.section} of {spec_of(version)}.")
    code = int(bool(counts[FAILED] or counts[UNEXPECTED]))
    if options.json is not None:
        _write_report(options.json, version, code, counts, outcomes)
    return code


def _write_report(file, version, code, counts, outcomes):
    report = {
        "stylit-ref": __version__,
        "cases": version,
        "exit_code": code,
        "counts": counts,
        "outcomes": [
            outcome._asdict()
            | {"difference": outcome.difference._asdict() if outcome.difference else None}
            for outcome in outcomes
        ],
    }
    write_text(file, json.dumps(report, indent=1, ensure_ascii=False, allow_nan=False) + "\n")


def _stages(text):
    """Stages of a list with commas, in the order of all."""
    wanted = [name.strip() for name in text.split(",")]
    for name in wanted:
        if name not in STAGES:
            raise InputError(f"{name!r} is no stage; there are {', '.join(STAGES)}")
    return [stage for stage in STAGES if stage in wanted]


def _port(options):
    if options.port is not None:
        if options.module is not None:
            raise InputError("--port and --module exclude each other")
        timeout = TIMEOUT if options.timeout is None else options.timeout
        return CommandPort(options.port, timeout)
    if options.timeout is not None:
        raise InputError("--timeout is for a --port; a module is not stopped")
    sys.path.insert(0, "")  # modules beside the reader, as for python -m
    return ModulePort("stylit_ref.passes" if options.module is None else options.module)


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
