"""Several processes do pieces of work whose results are files.

Python runs one thread at a time, so that threads would not help a compiler written in Python.
"""

import os
import signal
import sys
import threading
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

from numba import get_num_threads

_MOST = 256  # pieces: their numbers are bytes, and as many fit into any pipe


def share(pieces: Sequence[Callable[[], None]], beginning: Callable[[int], None]) -> None:
    """Call functions in as many processes as a run has threads, each function in one of them.

    This process takes the first one. The others are forks of it; each process that is done takes
    the first function that none has taken yet. What a fork fails at is left undone. There are no
    forks where this process has other threads of Python, since their locks might stay closed for
    ever, nor on other systems than Linux.

    Parameters
    ----------
    pieces : sequence of callable
        Only 256 of them are called.
    beginning : callable
        Called with the number of a function, from 0, before this process calls it.
    """
    count = min(len(pieces), _MOST)
    waiting, end = os.pipe()
    os.write(end, bytes(range(1, count)))  # the first is for this process
    os.close(end)

    def work():
        while taken := os.read(waiting, 1):
            pieces[taken[0]]()

    forks = []
    try:
        while len(forks) < min(possible_processes(), count) - 1:
            forks.append(_fork(work))
        taken = b"\0"
        while taken:
            beginning(taken[0])
            pieces[taken[0]]()
            taken = os.read(waiting, 1)
        while forks:
            os.waitpid(forks[-1], 0)
            forks.pop()
    finally:
        os.close(waiting)
        for fork in forks:
            os.kill(fork, signal.SIGKILL)
            os.waitpid(fork, 0)


def possible_processes() -> int:
    """As many as a run has threads, or 1 where there are no forks (:func:`share`).

    Asking starts Numba's threads. A fork of a process that has them knows that it has lost them.
    """
    if sys.platform != "linux" or threading.active_count() > 1:
        return 1
    return get_num_threads()


@contextmanager
def forking() -> Iterator[None]:
    """While the block forks, Python does not warn of threads.

    Those of libraries, which alone there are, wait and hold no lock.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        yield


def _fork(work):
    """Do the work in another process, which then ends; returns its number."""
    with forking():
        fork = os.fork()
    if fork:
        return fork
    try:
        work()
    finally:
        os._exit(0)
