"""Do work on this machine side by side, each piece in a process that computes on one thread.

So no run waits for the slowest of its threads, and while one is measured, another one is done. A
run's image does not depend on the number of threads, and its processor time hardly does.
"""

import multiprocessing
import signal
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from ctypes import CDLL
from functools import partial

import numba
from threadpoolctl import threadpool_limits

from eval.runs.local import do_here, work
from stylit_ref.machine.shared_work import forking, possible_processes

MOST = 8
"""Processes. A run of 1200x912 pixels takes up to a gigabyte."""

_PR_SET_PDEATHSIG = 1
_pieces = ()


def do_side_by_side(tasks, bar):
    """Do tasks, as :func:`eval.runs.local.do_here` does them one after another.

    Those whose method is to be ``alone`` are done one after another, on all threads: beside others
    their times would be those of a busy machine. So are all that :func:`_in_processes` leaves.
    """
    together = [task for task in tasks if not _is_alone(task)]
    # The longest begin first, so that no process has a long one left when the others are done.
    together.sort(key=lambda task: -task.job.cost)
    alone = [task for task in tasks if _is_alone(task)]
    left = dict(enumerate(together))
    pieces = [partial(work, task.job, task.metrics) for task in together]
    for number, outcome in _in_processes(pieces):
        task = left.pop(number)
        bar.set_description_str(task.job.title)
        yield task, outcome
        bar.update(task.job.cost)
    yield from do_here([*left.values(), *alone], bar)


def _is_alone(task):
    return getattr(task.job.method, "alone", False)


def do_all(pieces):
    """Call functions that return nothing, side by side where there are several.

    Parameters
    ----------
    pieces : dict of callable

    Returns
    -------
    dict of Exception
        What some of them ended with, by the same keys; the others were called all the same.
    """
    keys, ends = list(pieces), {}
    for number, end in _in_processes(list(pieces.values())):
        ends[keys[number]] = end
    for key in keys:
        if key not in ends:
            try:
                ends[key] = pieces[key]()
            except Exception as error:
                ends[key] = error
    return {key: end for key, end in ends.items() if end is not None}


def _in_processes(pieces):
    """Call functions, each in one of several processes.

    Parameters
    ----------
    pieces : sequence of callable
        They need not be known to :mod:`pickle`, but what they return is.

    Yields
    ------
    The number of each that is done, and what it returned or the exception it ended with. Some are
    left to the caller: those that a process was doing or would have done when one was killed, as
    where memory is short; and all, if there is one piece or one thread, or if processes cannot be
    forked safely, since this one has other threads or the system is not Linux.
    """
    processes = min(possible_processes(), len(pieces), MOST)
    if processes < 2:
        return
    pool = ProcessPoolExecutor(
        processes, multiprocessing.get_context("fork"), _begin, (tuple(pieces),)
    )
    try:
        with forking():
            futures = {pool.submit(_call, number): number for number in range(len(pieces))}
        for future in as_completed(list(futures)):
            number = futures.pop(future)  # else results would be kept until the last is there
            try:
                outcome = future.result()
            except BrokenProcessPool:
                continue
            except Exception as error:
                outcome = error
            del future
            yield number, outcome
    except BaseException:
        for process in multiprocessing.active_children():
            process.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _begin(pieces):
    """A process begins. Ctrl-C is for the process that gives it work, and it ends with that one."""
    global _pieces
    _pieces = pieces
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    numba.set_num_threads(1)
    threadpool_limits(1)  # of NumPy's linear algebra


def _call(number):
    return _pieces[number]()
