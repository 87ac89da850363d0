"""Ports that do not use the library: a program, or a module with ``run_case``."""

import contextlib
import os
import re
import shlex
import shutil
import signal
import subprocess
import tempfile
from importlib import import_module
from pathlib import Path
from types import ModuleType

from oracle.cases import Case, CaseError, read_array, write_input
from oracle.compare import NoPortError, NotOfferedError
from stylit_ref.errors import InputError, one_line

TIMEOUT = 60
"""Seconds that a program may take for a case by default."""

EXIT_NOT_OFFERED = 77
"""Exit code of a program that does not offer the stage: a skipped test's in Automake and Meson."""


class CommandPort:
    """A port that is a command; ``{input}`` and ``{output}`` in it stand for two folders.

    Parameters
    ----------
    command : str
    timeout : float
        Seconds that it may take for a case.

    Raises
    ------
    InputError
        If the command lacks one of them, its program is not found, or the timeout is not positive.
    """

    def __init__(self, command: str, timeout: float = TIMEOUT):
        if not timeout > 0:
            raise InputError(f"is {timeout:g}; it must be above 0", parameter="timeout")
        if "{input}" not in command or "{output}" not in command:
            raise InputError(f"{command!r} must contain {{input}} and {{output}}", parameter="port")
        try:
            self.words = shlex.split(command)
        except ValueError as error:
            raise InputError(f"{command!r} is not a command: {error}", parameter="port") from None
        if not shutil.which(self.words[0]):
            program = self.words[0]
            raise InputError(
                f"{command!r} cannot be run: there is no program {program!r}", parameter="port"
            )
        self.timeout = timeout

    def __call__(self, case: Case) -> dict:
        """The arrays that the program writes for a case."""
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
    """Run a program for at most ``timeout`` seconds; its output goes to the file ``log``.

    Processes that it started are ended with it.
    """
    with log.open("wb") as said:
        try:
            program = subprocess.Popen(
                words, stdin=subprocess.DEVNULL, stdout=said, stderr=said, start_new_session=True
            )
        except OSError as error:
            raise NoPortError(f"{words[0]} cannot be started: {error.strerror}") from None
        try:
            code = program.wait(timeout)
        except subprocess.TimeoutExpired:
            raise CaseError(f"did not end within {timeout:g} s") from None
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(program.pid, signal.SIGKILL)
            program.wait()
    if code == EXIT_NOT_OFFERED:
        raise NotOfferedError
    if code:
        said = _complaint(log)
        raise CaseError(f"{_end(code)}: {said}" if said else _end(code))


def _end(code):
    """How a program ended: its exit code, or the signal (by number if it has no name)."""
    if code > 0:
        return f"exit code {code}"
    names = {known.value: known.name for known in signal.Signals}
    return f"signal {names.get(-code, -code)}"


_ERROR = re.compile(r"error|exception|panic|fatal|abort|assert|\bfault|terminate", re.IGNORECASE)


def _complaint(log):
    """The output of a program that failed, in one line of limited length.

    It has the first line that looks like an error, since a list of calls often follows it, and the
    last three lines, where Python prints its error.
    """
    with log.open("rb") as said:
        first = next(filter(_ERROR.search, _lines(said.read(2**20))), None)
        said.seek(max(0, log.stat().st_size - 4096))
        last = _lines(said.read())[-3:]
    end = " | ".join(last)
    if len(end) <= 300 and (first is None or first in last):
        return end
    if first is None:
        return f"...{end[-300:]}"
    first = first if len(first) <= 150 else f"{first[:150]}..."
    return f"{first} | ...{end[-150:]}" if len(end) > 150 else f"{first} | ... | {end}"


def _lines(content):
    """The non-empty lines of a text."""
    lines = (one_line(line).strip() for line in content.decode(errors="replace").split("\n"))
    return [line for line in lines if line]


class ModulePort:
    """A port that is a Python module with ``run_case(stage, parameters, arrays)``.

    Parameters
    ----------
    name : str

    Raises
    ------
    InputError
        If it cannot be imported.
    """

    def __init__(self, name: str):
        self.name = name
        import_port(name)

    def __call__(self, case: Case) -> dict:
        """The arrays that the module gives for a case."""
        module = import_module(self.name)
        try:
            found = module.run_case(case.stage, case.parameters, dict(case.arrays))
        except NotImplementedError:
            raise NotOfferedError from None
        if not isinstance(found, dict):
            raise CaseError(
                f"run_case returned {type(found).__name__}; it must return a dict of arrays"
            )
        return found


def import_port(name: str) -> ModuleType:
    """Import a module that a user names.

    Raises
    ------
    InputError
        If it cannot be imported.
    """
    try:
        return import_module(name)
    except (Exception, SystemExit) as error:
        what = f"{type(error).__name__}: {error}"
        if name.endswith(".py"):
            what = f"Python imports modules by name; write {name.removesuffix('.py')}"
        raise InputError(f"{name!r} cannot be imported: {what}", parameter="module") from None
