"""Does a port give what it must? If not, the first stage, pixel and value that differ."""

import shlex
import subprocess
import tempfile
from fnmatch import fnmatchcase
from pathlib import Path
from typing import NamedTuple

import numpy as np

from oracle.cases import SECTIONS, STAGES, read_arrays, read_cases, write_input
from stylit_ref.errors import InputError

PASSED, FAILED, EXPECTED, UNEXPECTED = (
    "passed",
    "failed",
    "failed as expected",
    "passed unexpectedly",
)


class Outcome(NamedTuple):
    """What became of a case.

    Attributes
    ----------
    title, section : str
    status : str
    message : str
        What differs; empty where nothing does.
    """

    title: str
    section: str
    status: str
    message: str


def check(port, version, stages=STAGES, expected_failures=()):
    """Run a port on the cases of some stages.

    Parameters
    ----------
    port : callable
        ``(case) -> dict of str to array``; :func:`command_port` or :func:`module_port`.
    version : str
    stages : sequence of str
    expected_failures : set of str
        Titles of cases that may fail, ``*`` standing for anything.

    Yields
    ------
    Outcome
    """
    for case in read_cases(version, stages):
        message = _difference(case, port)
        expected = any(fnmatchcase(case.title, pattern) for pattern in expected_failures)
        status = (
            (EXPECTED if expected else FAILED) if message else UNEXPECTED if expected else PASSED
        )
        yield Outcome(case.title, SECTIONS[case.stage], status, message)


def _difference(case, port):
    """The first thing in which a port's outputs are not those of a case, or nothing."""
    try:
        found = port(case)
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    for name, expected in case.expected.items():
        if name not in found:
            return f"{name} is not there"
        message = _array_difference(found[name], expected, case.tolerances.get(name))
        if message:
            return f"{name}{message}"
    return ""


def _array_difference(found, expected, tolerance):
    found = np.asarray(found)
    if found.shape != expected.shape:
        return f" has shape {found.shape}; it must be {expected.shape}"
    if found.dtype != expected.dtype:
        return f" is {found.dtype}; it must be {expected.dtype}"
    if tolerance is None:
        differs = found != expected
    else:
        differs = ~np.isclose(found, expected, rtol=tolerance, atol=0)
    if not differs.any():
        return ""
    first = tuple(int(axis[0]) for axis in np.nonzero(np.atleast_1d(differs)))
    place = f"[{', '.join(map(str, first))}]" if expected.ndim else ""
    values = (np.atleast_1d(array)[first] for array in (found, expected))
    count = int(differs.sum())
    return "{} is {}; it must be {} ({} of {} differ)".format(place, *values, count, expected.size)


def command_port(command, timeout=600):
    """A port that is a command, ``{input}`` and ``{output}`` in the places of two folders.

    Raises
    ------
    InputError
        If the command lacks one of them.
    """
    if "{input}" not in command or "{output}" not in command:
        raise InputError(f"port {command!r} must name {{input}} and {{output}}")

    def run(case):
        with tempfile.TemporaryDirectory(prefix="oracle-") as folder:
            given, made = Path(folder) / "input", Path(folder) / "output"
            write_input(case, given)
            made.mkdir()
            words = [
                word.replace("{input}", str(given)).replace("{output}", str(made))
                for word in shlex.split(command)
            ]
            done = subprocess.run(
                words, check=False, capture_output=True, text=True, timeout=timeout
            )
            if done.returncode:
                said = done.stderr.strip().splitlines()
                raise RuntimeError(f"exit code {done.returncode}: {said[-1] if said else ''}")
            return read_arrays(made)

    return run


def module_port(module):
    """A port that is a Python module.

    It offers ``run_case(stage, parameters, arrays)``, or the functions of
    :mod:`stylit_ref.passes`.
    """
    from oracle import stages

    if hasattr(module, "run_case"):
        return lambda case: module.run_case(case.stage, case.parameters, dict(case.arrays))
    backend = "cuda" if module.__name__.startswith("gpu_cuda") else "cpu"
    return lambda case: stages.run_case(
        case.stage, case.parameters, dict(case.arrays), module, backend
    )
