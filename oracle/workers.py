"""Share the cases among processes; at the end none of them is left, nor a program they started."""

import contextlib
import os
import signal
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from functools import partial
from multiprocessing import active_children, get_context

from oracle.cases import Case
from oracle.compare import NoPortError, Outcome


def shared(
    outcome_of: Callable[[Case], Outcome], cases: Iterable[Case], jobs: int
) -> Iterator[Outcome]:
    """Map a function over the cases with several processes; call it from the main thread.

    Parameters
    ----------
    outcome_of : callable
        ``(case) -> Outcome``; it must be picklable.
    cases : iterable of Case
    jobs : int
        How many processes.

    Yields
    ------
    Outcome
        In the order of the cases.

    Raises
    ------
    NoPortError
        If a process ended.
    """
    others = set(active_children())
    pool = ProcessPoolExecutor(jobs, get_context("spawn"), _begin_worker)
    try:
        with _without_interruption():
            outcomes = pool.map(partial(_by_worker, outcome_of), cases)
        yield from outcomes
    except BrokenProcessPool:
        raise NoPortError(
            "the module ended the process that it ran in; check it as a program with --port"
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
    """Put off Ctrl-C and SIGTERM: a process that is just starting cannot handle them."""
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
    """Let workers survive Ctrl-C, which reaches all processes of a terminal; SIGTERM ends them.

    The handler does nothing instead of ignoring the signal: programs that a worker runs would
    inherit the latter.
    """
    signal.signal(signal.SIGINT, lambda *_: None)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


def _by_worker(outcome_of, case):
    """The outcome of a case; SIGTERM ends the worker once the program that it runs is gone."""
    try:
        signal.signal(signal.SIGTERM, _interrupt_once)
        return outcome_of(case)
    except KeyboardInterrupt:
        os._exit(130)
    finally:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)


def _interrupt_once(*_):
    """Raise KeyboardInterrupt; a second signal must not interrupt the cleaning up."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise KeyboardInterrupt
