"""Ctrl-C and SIGTERM end a program in the same way, wherever they strike."""

import signal
from _thread import interrupt_main
from pathlib import Path
from threading import Timer

import llvmlite
import numba

COMPILERS = tuple(str(Path(package.__file__).parent) for package in (numba, llvmlite))


def heed_interruptions():
    """Have both raise KeyboardInterrupt in the main thread, for a program to call at its start.

    Not within a compiler, which would lose the exception where LLVM calls back, or free the same
    module twice: there they wait until the kernel is compiled.
    """
    for number in (signal.SIGINT, signal.SIGTERM):
        if signal.getsignal(number) is not signal.SIG_IGN:  # as a shell has it in the background
            signal.signal(number, _interrupt)


def _interrupt(number, frame):
    if not _is_compiling(frame):
        raise KeyboardInterrupt
    again = Timer(0.05, interrupt_main, [number])
    again.daemon = True
    again.start()


def _is_compiling(frame):
    while frame:
        if frame.f_code.co_filename.startswith(COMPILERS):
            return True
        frame = frame.f_back
    return False
