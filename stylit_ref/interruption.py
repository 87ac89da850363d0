"""Ctrl-C and SIGTERM end a program in the same way, wherever they strike."""

import signal
import sys
from _thread import interrupt_main
from threading import Timer


def heed_interruptions():
    """Have both raise KeyboardInterrupt in the main thread, for a program to call at its start."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    sys.unraisablehook = _unraisable


def _unraisable(unraisable):
    """Where C code calls back, an exception cannot rise: Ctrl-C would be lost in the compiler."""
    if unraisable.exc_type is KeyboardInterrupt:
        again = Timer(0.05, interrupt_main)
        again.daemon = True
        again.start()
    else:
        sys.__unraisablehook__(unraisable)
