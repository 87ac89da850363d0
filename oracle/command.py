"""``stylit-ref oracle check``: which stage a port gets wrong."""

import importlib
import json
from collections import Counter
from importlib.metadata import version as version_of
from pathlib import Path

from tqdm import tqdm

from oracle.cases import STAGES, VERSIONS, damaged_files, folder_of
from oracle.check import FAILED, UNEXPECTED, check, command_port, module_port
from stylit_ref.errors import InputError


def check_port(options):
    """Check one port, or without one this library's own passes.

    Parameters
    ----------
    options : argparse.Namespace
        ``port``, ``module``, ``stages``, ``xfail``, ``json``, ``cases``.

    Returns
    -------
    int
        Exit code: 0 if all is as expected, otherwise 1.
    """
    version = options.cases or VERSIONS[-1]
    if version not in VERSIONS:
        raise InputError(f"there are no cases {version!r}; there are {', '.join(VERSIONS)}")
    stages = options.stages.split(",") if options.stages else STAGES
    for stage in stages:
        if stage not in STAGES:
            raise InputError(f"{stage!r} is no stage; there are {', '.join(STAGES)}")
    damaged = damaged_files(version)
    if damaged:
        raise InputError(f"{folder_of(version) / damaged[0]}: differs from SHA256SUMS")
    port = _port(options)
    expected = _expected_failures(options.xfail)
    outcomes = list(tqdm(check(port, version, stages, expected), unit="case", disable=None))
    bad = [outcome for outcome in outcomes if outcome.status in (FAILED, UNEXPECTED)]
    for outcome in bad:
        print(f"{outcome.title}: {outcome.status}: {outcome.message}".rstrip(": "))
    counts = Counter(outcome.status for outcome in outcomes)
    print(", ".join(f"{count} {status}" for status, count in counts.items()))
    failed = [outcome for outcome in bad if outcome.status == FAILED]
    if failed:
        stage = failed[0].title.partition("/")[0]
        print(f"Begin with stage {stage}: section {failed[0].section} of {SPEC}.")
    if options.json:
        report = {
            "stylit-ref": version_of("stylit-ref"),
            "cases": version,
            "outcomes": [outcome._asdict() for outcome in outcomes],
        }
        text = json.dumps(report, indent=1, ensure_ascii=False)
        Path(options.json).write_text(text + "\n", encoding="utf-8")
    return int(bool(bad))


SPEC = Path(__file__).with_name("SPEC.md")


def _port(options):
    if options.port and options.module:
        raise InputError("--port and --module exclude each other")
    if options.port:
        return command_port(options.port)
    name = options.module or "stylit_ref.passes"
    try:
        return module_port(importlib.import_module(name))
    except ImportError as error:
        raise InputError(f"{name}: cannot be imported: {error}") from None


def _expected_failures(file):
    """Patterns of titles, one a line; what follows # is a remark."""
    if file is None:
        return set()
    try:
        lines = Path(file).read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise InputError(f"{file}: cannot be read: {error.strerror}") from None
    return {line.partition("#")[0].strip() for line in lines} - {""}
