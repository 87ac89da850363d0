"""What the entry point refuses before the library is loaded."""

import os
import subprocess
import sys

import pytest


def entered(program, **environment):
    """Exit code and stderr of a process that enters the command line."""
    done = subprocess.run(
        [sys.executable, *program],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
    )
    return done.returncode, done.stderr


@pytest.mark.parametrize("threads", ["0", "-1", "two"])
def test_a_number_of_threads_that_is_none(threads):
    assert entered(["-m", "stylit_ref", "doctor"], NUMBA_NUM_THREADS=threads) == (
        2,
        f"stylit-ref: NUMBA_NUM_THREADS is {threads!r}; it must be an integer of at least 1\n",
    )


def test_a_package_that_is_missing():
    program = "import sys; sys.modules['numba'] = None; import stylit_ref.__main__ as entry; "
    code, said = entered(["-c", program + "entry.command()"])
    assert code == 2
    assert said.startswith(
        "stylit-ref: the package 'numba' is missing; install stylit-ref with all"
    )
    assert said.count("\n") == 1


@pytest.mark.parametrize("module", ["stylit_ref", "stylit_ref.cli"])
def test_a_module_is_entered_as_the_program(module):
    assert entered(["-m", module, "--version"]) == (0, "")


def test_an_interruption_while_the_library_is_loaded():
    program = "import builtins, stylit_ref.__main__ as entry; load = builtins.__import__\n"
    program += "def interrupted(name, *rest):\n"
    program += "    if name == 'numba': raise KeyboardInterrupt\n"
    program += "    return load(name, *rest)\n"
    program += "builtins.__import__ = interrupted; entry.command()"
    assert entered(["-c", program]) == (130, "stylit-ref: interrupted\n")
