"""Ctrl-C and SIGTERM end a program in the same way, whenever they come."""

import signal
from _thread import interrupt_main
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import Timer

import llvmlite
import numba

COMPILERS = tuple(str(Path(package.__file__).parent) for package in (numba, llvmlite))

_waiting: Timer | None = None
"""Repeats an interruption that a compiler has put off."""


def heed_interruptions() -> None:
    """Have both raise KeyboardInterrupt in the main thread, for a program to call at its start.

    While a kernel is compiled they wait until it is done (:func:`heed_waiting`): the compiler loses
    an exception that is raised in a callback of LLVM, or frees the same module twice.
    """
    for number in (signal.SIGINT, signal.SIGTERM):
        if signal.getsignal(number) is not signal.SIG_IGN:  # as a shell has it in the background
            signal.signal(number, _interrupt)


def heed_waiting() -> None:
    """Interrupt now, if an interruption waits for the compiler; to be called between two kernels.

    Without it, a program that compiles kernel after kernel would end after the last one alone.

    Raises
    ------
    KeyboardInterrupt
    """
    global _waiting
    if _waiting is not None:
        _waiting.cancel()
        _waiting = None
        raise KeyboardInterrupt


@contextmanager
def put_off_interruptions() -> Iterator[Callable[[], bool]]:
    """Have the first interruption of the block only be remembered; a second one interrupts.

    Yields
    ------
    callable
        Whether an interruption came.
    """
    came = False

    def remember(number, frame):
        nonlocal came
        came = True
        signal.signal(number, before[number])

    numbers = [
        number
        for number in (signal.SIGINT, signal.SIGTERM)
        if signal.getsignal(number) is not signal.SIG_IGN
    ]
    before = {number: signal.signal(number, remember) for number in numbers}
    try:
        yield lambda: came
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _interrupt(number, frame):
    global _waiting
    if not _is_compiling(frame):
        _waiting = None
        raise KeyboardInterrupt
    again = Timer(0.05, lambda: _waiting is again and interrupt_main(number))
    again.daemon = True
    _waiting = again
    again.start()


def _is_compiling(frame):
    while frame:
        if frame.f_code.co_filename.startswith(COMPILERS):
            return True
        frame = frame.f_back
    return False
