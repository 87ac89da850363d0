"""No two processes do the same work at the same time, where its result is a file for all of them.

Where two runs start together on a machine that has no kernels yet, each compiles those that the
other does not.
"""

import os
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

_FILE = "compiling.lock"
_PLACES = 1 << 62
_PATIENCE = 60.0
"""Seconds: a process that has begun the work may have been stopped."""
_PAUSE = 0.02


@contextmanager
def once(
    folder: Path, number: int, is_done: Callable[[], bool], *, waiting: bool
) -> Iterator[bool]:
    """Keep other processes from some work while the block runs.

    Other threads of this process are not kept from it. Where the system or the folder has no locks,
    every process does the work.

    Parameters
    ----------
    folder : Path
        Where the result is kept. A file in it is locked, each piece of work at a place of its own.
        The system unlocks it when a process ends, however it ends.
    number : int
        Identifies the work.
    is_done : callable
        Whether the result is there.
    waiting : bool
        Whether to wait for a process that has begun the work until the result is there, but for a
        minute at most.

    Yields
    ------
    bool
        Whether to do the work: no other process has begun it, or it was waited for.
    """
    file, place = _open(folder), number % _PLACES
    is_ours = file is None or _lock(file, place)
    if waiting and not is_ours:
        _wait(file, place, is_done)
    try:
        yield is_ours or waiting
    finally:
        if is_ours and file is not None:
            _unlock(file, place)


def _wait(file, place, is_done):
    """Wait until the result is there, or nobody does the work any more: then all who waited do it.

    Where a result cannot be kept, as on a full disk, they would else do it one after another.
    """
    end = time.monotonic() + _PATIENCE
    while not is_done() and time.monotonic() < end:
        time.sleep(_PAUSE)
        if _lock(file, place):
            _unlock(file, place)
            return


@cache
def _open(folder):
    """The file to lock. It stays open, since closing it would unlock all its places."""
    if fcntl is None:
        return None
    try:
        folder.mkdir(parents=True, exist_ok=True)
        return os.open(folder / _FILE, os.O_RDWR | os.O_CREAT, 0o666)
    except OSError:
        return None


def _lock(file, place):
    """Whether a place is locked for this process; True also where there are no locks."""
    try:
        fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, place)
    except (BlockingIOError, PermissionError):
        return False
    except OSError:
        return True
    return True


def _unlock(file, place):
    with suppress(OSError):
        fcntl.lockf(file, fcntl.LOCK_UN, 1, place)
