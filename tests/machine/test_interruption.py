"""Where Ctrl-C and SIGTERM may strike."""

import signal
import time
from pathlib import Path

import numba
import numpy as np
import pytest
from numba.core import event

from stylit_ref.machine.compilation import compile_missing
from stylit_ref.machine.interruption import heed_interruptions, heed_waiting
from stylit_ref.machine.kernel import kernel, rehearsal

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


def test_a_signal_that_waits_strikes_between_two_kernels_and_once():
    names = {"strike": lambda: signal.raise_signal(signal.SIGINT)}
    source = "def compiling():\n    strike()"
    exec(compile(source, str(Path(numba.__file__).with_name("compiler.py")), "exec"), names)
    names["compiling"]()
    with pytest.raises(KeyboardInterrupt):
        heed_waiting()
    heed_waiting()
    time.sleep(0.2)  # a second interruption would strike here


def test_nothing_waits_when_nothing_struck():
    heed_waiting()


class Strike(event.Listener):
    """Sends a signal whenever a kernel begins to be compiled."""

    def on_start(self, event):
        signal.raise_signal(signal.SIGINT)

    def on_end(self, event):
        pass


@pytest.fixture(params=["kept", "not kept"])
def _folder_for_kernels(request, tmp_path, monkeypatch):
    if request.param == "kept":
        monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))
    else:

        def nowhere(*_):
            raise RuntimeError("no locator available")

        monkeypatch.setattr("stylit_ref.machine.kernel.KernelCache.__init__", nowhere)


@pytest.fixture
def two_kernels(_folder_for_kernels):
    """Two kernels that nobody has compiled."""

    @kernel(1, parallel=False)
    def first(array):
        array[0] = 1

    @kernel(2, parallel=False)
    def second(array):
        array[0] = 2

    return first, second


def test_an_interruption_waits_for_one_kernel_and_not_for_the_next(two_kernels):
    with rehearsal() as found:
        for each in two_kernels:
            each(np.zeros(1))
    told = []
    with event.install_listener("numba:compile", Strike()), pytest.raises(KeyboardInterrupt):
        compile_missing(found, lambda *step: told.append(step))
    assert told == [(1, 2)]
    assert [bool(each.dispatcher.overloads) for each in two_kernels] == [True, False]


def test_an_interruption_while_a_kernel_is_called_waits_for_it_alone(two_kernels):
    def call():
        for each in two_kernels:
            each(np.zeros(1))

    with event.install_listener("numba:compile", Strike()), pytest.raises(KeyboardInterrupt):
        call()
    assert [bool(each.dispatcher.overloads) for each in two_kernels] == [True, False]
