"""Where Ctrl-C and SIGTERM may strike."""

import signal
import time
from pathlib import Path

import numba
import pytest

from stylit_ref.machine.interruption import heed_interruptions

SIGNALS = signal.SIGINT, signal.SIGTERM


@pytest.fixture(autouse=True)
def _heeded():
    before = [signal.getsignal(number) for number in SIGNALS]
    heed_interruptions()
    yield
    for number, handler in zip(SIGNALS, before, strict=True):
        signal.signal(number, handler)


@pytest.mark.parametrize("number", SIGNALS)
def test_a_signal_interrupts_at_once(number):
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(number)


@pytest.mark.parametrize("number", SIGNALS)
def test_a_signal_waits_for_the_compiler(number):
    done = []
    names = {"strike": lambda: signal.raise_signal(number), "done": done, "time": time}
    source = "def compiling():\n    strike()\n    time.sleep(0.2)\n    done.append('compiled')"
    exec(compile(source, str(Path(numba.__file__).with_name("compiler.py")), "exec"), names)
    with pytest.raises(KeyboardInterrupt):  # noqa: PT012
        names["compiling"]()
        for _ in range(500):  # a signal that was put off does not end a sleep
            time.sleep(0.01)
    assert done == ["compiled"]


def test_a_signal_that_a_shell_ignores_stays_ignored():
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    heed_interruptions()
    signal.raise_signal(signal.SIGINT)
