"""Does a port give what it must? If not, the first stage, pixel and value that differ."""

import contextlib
import math
import os
import shlex
import shutil
import signal
import subprocess
import tempfile
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from fnmatch import fnmatchcase
from functools import partial
from importlib import import_module
from multiprocessing import active_children, get_context
from pathlib import Path
from typing import NamedTuple

import numpy as np

from oracle.cases import STAGES, CaseError, read_array, read_cases, write_input
from oracle.stages import NEEDS, is_offered, run_case
from stylit_ref.errors import InputError

PASSED, FAILED, NOT_OFFERED, EXPECTED, UNEXPECTED = (
    "passed",
    "failed",
    "not offered",
    "failed as expected",
    "passed unexpectedly",
)


TIMEOUT = 60
"""Seconds that a program may take for a case where nobody says otherwise."""


class NotOfferedError(Exception):
    """A port does not do a stage."""


class NoProgramError(InputError):
    """A port cannot be started, whatever the case."""


class Difference(NamedTuple):
    """What is wrong with a port's output.

    Attributes
    ----------
    message : str
    array : str or None
        The output concerned.
    index : list of int or None
        The first element that differs.
    found, expected : int, float, bool or None
        None also for what is no finite number: JSON has none, the message says it.
    """

    message: str
    array: str | None = None
    index: list[int] | None = None
    found: int | float | bool | None = None
    expected: int | float | bool | None = None


class Outcome(NamedTuple):
    """What became of a case.

    Attributes
    ----------
    stage, name, section : str
    status : str
    difference : Difference or None
    """

    stage: str
    name: str
    section: str
    status: str
    difference: Difference | None

    @property
    def title(self):
        """Stage and name."""
        return f"{self.stage}/{self.name}"


def check(port, version, stages=STAGES, expected_failures=(), jobs=1):
    """Run a port on the cases of some stages.

    Parameters
    ----------
    port : callable
        ``(case) -> dict of str to array``; :class:`CommandPort` or :class:`ModulePort`.
    version : str
    stages : sequence of str
    expected_failures : set of str
        Titles of cases that must fail, ``*`` standing for anything.
    jobs : int
        Processes that share the cases; with more than one the port is sent to them, and only a
        main thread may ask for it.

    Yields
    ------
    Outcome
        In the order of the cases.

    Raises
    ------
    InputError
        If the port cannot be started, or ended the process of the checker it ran in.
    """
    one = partial(_outcome, port, expected_failures)
    cases = read_cases(version, stages)
    yield from map(one, cases) if jobs == 1 else _shared(one, cases, jobs)


def _shared(one, cases, jobs):
    """As map, by several processes; none of them is left, nor a program that they run."""
    others = set(active_children())
    pool = ProcessPoolExecutor(jobs, get_context("spawn"), _begin_worker)
    try:
        with _without_interruption():
            outcomes = pool.map(partial(_by_worker, one), cases)
        yield from outcomes
    except BrokenProcessPool:
        raise InputError(
            "the module ended the process it ran in; what does so is checked as a program, --port"
        ) from None
    finally:
        workers = set(active_children()) - others
        pool.shutdown(wait=False, cancel_futures=True)
        for worker in workers:
            worker.terminate()
        for worker in workers:
            worker.join(5)
            worker.kill()


@contextlib.contextmanager
def _without_interruption():
    """Ctrl-C and SIGTERM wait: they would leave a process half begun, or strike it as it begins."""
    signals, waiting = (signal.SIGINT, signal.SIGTERM), []
    handlers = [signal.signal(one, lambda number, _: waiting.append(number)) for one in signals]
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})  # processes inherit it
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        for number, handler in zip(signals, handlers, strict=True):
            signal.signal(number, handler)
        for number in waiting:
            signal.raise_signal(number)


def _begin_worker():
    """Ctrl-C strikes all processes of a terminal: the first of them ends the others by SIGTERM.

    A handler of its own, as programs that a worker runs would inherit that a signal is ignored.
    """
    signal.signal(signal.SIGINT, lambda *_: None)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


def _by_worker(one, case):
    """What one makes of a case; SIGTERM ends the worker when the program it runs is gone."""
    try:
        signal.signal(signal.SIGTERM, _interrupt_once)
        return one(case)
    except KeyboardInterrupt:
        os._exit(130)
    finally:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)


def _interrupt_once(*_):
    """As Ctrl-C; another one must not strike who tidies up."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise KeyboardInterrupt


def _outcome(port, expected_failures, case):
    expected = any(fnmatchcase(case.title, pattern) for pattern in expected_failures)
    difference = None
    try:
        difference = _first_difference(case, port(case))
        status = FAILED if difference else PASSED
    except NotOfferedError:
        status = NOT_OFFERED
    except NoProgramError:
        raise
    except CaseError as error:
        difference, status = Difference(str(error)), FAILED
    except (Exception, SystemExit) as error:  # a module's own may say anything
        message = f"{type(error).__name__}: {error}".encode(errors="backslashreplace").decode()
        difference, status = Difference(message), FAILED
    if expected:
        status = {FAILED: EXPECTED, PASSED: UNEXPECTED}.get(status, status)
    return Outcome(case.stage, case.name, case.section, status, difference)


def _first_difference(case, found):
    for name, expected in case.expected.items():
        if name not in found:
            return Difference(f"{name} is not there", name)
        difference = _difference(name, np.asarray(found[name]), expected, case.tolerances.get(name))
        if difference:
            return difference
    return None


def _difference(name, found, expected, tolerance):
    if found.shape != expected.shape:
        return Difference(f"{name} has shape {found.shape}; it must be {expected.shape}", name)
    if found.dtype != expected.dtype:
        return Difference(f"{name} is {found.dtype}; it must be {expected.dtype}", name)
    if tolerance is None:
        differs = found != expected
    else:
        differs = ~np.isclose(found, expected, rtol=tolerance, atol=0)
    if not differs.any():
        return None
    index = tuple(int(axis[0]) for axis in np.nonzero(np.atleast_1d(differs)))
    values = [np.atleast_1d(array)[index].item() for array in (found, expected)]
    finite = [value if math.isfinite(value) else None for value in values]
    place = f"[{', '.join(map(str, index))}]" if expected.ndim else ""
    message = "{}{} is {}; it must be {} ({} of {} differ)".format(
        name, place, *values, int(differs.sum()), expected.size
    )
    return Difference(message, name, list(index), *finite)


class CommandPort:
    """A port that is a command, ``{input}`` and ``{output}`` in the places of two folders.

    Parameters
    ----------
    command : str
    timeout : float
        Seconds that it may take for a case.

    Raises
    ------
    InputError
        If the command lacks one of them, there is no such program, or no such time.
    """

    def __init__(self, command, timeout=TIMEOUT):
        if not timeout > 0:
            raise InputError(f"timeout is {timeout:g}; it must be above 0")
        if "{input}" not in command or "{output}" not in command:
            raise InputError(f"port {command!r} must name {{input}} and {{output}}")
        try:
            self.words = shlex.split(command)
        except ValueError as error:
            raise InputError(f"port {command!r} is no command: {error}") from None
        if not shutil.which(self.words[0]):
            program = self.words[0]
            raise InputError(f"port {command!r}: there is no program {program!r} that can be run")
        self.timeout = timeout

    def __call__(self, case):
        with tempfile.TemporaryDirectory(prefix="oracle-") as folder:
            given, made = Path(folder) / "input", Path(folder) / "output"
            write_input(case, given)
            made.mkdir()
            places = {"{input}": str(given), "{output}": str(made)}
            filled = [_filled(word, places) for word in self.words]
            _run(filled, Path(folder) / "said", self.timeout)
            return {name: read_array(made / f"{name}.npy") for name in case.expected}


def _filled(word, places):
    for name, folder in places.items():
        word = word.replace(name, folder)
    return word


def _run(words, log, timeout):
    """Run a program and whatever it starts, for so long; what it says goes to a file."""
    with log.open("wb") as said:
        try:
            program = subprocess.Popen(
                words, stdin=subprocess.DEVNULL, stdout=said, stderr=said, start_new_session=True
            )
        except OSError as error:
            raise NoProgramError(f"{words[0]} cannot be started: {error.strerror}") from None
        try:
            code = program.wait(timeout)
        except subprocess.TimeoutExpired:
            raise CaseError(f"no end after {timeout:g} s") from None
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(program.pid, signal.SIGKILL)
            program.wait()
    if code:
        last = _last_words(log)
        raise CaseError(f"{_end(code)}: {last}" if last else _end(code))


def _end(code):
    """How a program ended; some signals have no name."""
    if code > 0:
        return f"exit code {code}"
    names = {known.value: known.name for known in signal.Signals}
    return f"signal {names.get(-code, -code)}"


def _last_words(log):
    """The last three lines of a file, or what a reader has patience for."""
    with log.open("rb") as said:
        said.seek(max(0, log.stat().st_size - 4096))
        text = said.read().decode(errors="replace")
    last = " | ".join([line.strip() for line in text.split("\n") if line.strip()][-3:])
    return last if len(last) <= 300 else f"...{last[-300:]}"


class ModulePort:
    """A port that is a Python module.

    Parameters
    ----------
    name : str
        It offers ``run_case(stage, parameters, arrays)``, or some of the functions of
        :mod:`stylit_ref.passes`.

    Raises
    ------
    InputError
        If it cannot be imported, or offers neither.
    """

    def __init__(self, name):
        self.name = name
        try:
            module = import_module(name)
        except (Exception, SystemExit) as error:
            what = f"{type(error).__name__}: {error}"
            raise InputError(f"module {name!r} cannot be imported: {what}") from None
        needed = {need for needs in NEEDS.values() for need in needs}
        if not hasattr(module, "run_case") and not any(hasattr(module, need) for need in needed):
            raise InputError(f"module {name!r} offers neither run_case nor a pass of this library")

    def __call__(self, case):
        module = import_module(self.name)
        if not hasattr(module, "run_case"):
            if not is_offered(case.stage, module):
                raise NotOfferedError
            return run_case(case.stage, case.parameters, dict(case.arrays), module)
        found = module.run_case(case.stage, case.parameters, dict(case.arrays))
        if not isinstance(found, dict):
            raise CaseError(
                f"run_case returned {type(found).__name__}; it must be a dict of arrays"
            )
        return found
