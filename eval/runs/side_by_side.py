"""Do runs on this machine side by side, each in a process of its own that computes on one thread.

So no run waits for the slowest of its threads, and while one is measured, another one is done. A
run's image does not depend on the number of threads, and its processor time hardly does.
"""

import multiprocessing
import signal
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from ctypes import CDLL

import numba
from threadpoolctl import threadpool_limits

from eval.runs.local import do_here, work
from stylit_ref.machine.shared_work import forking, possible_processes

MOST = 8
"""Processes. A run of 1200x912 pixels takes up to a gigabyte."""

_PR_SET_PDEATHSIG = 1
_tasks = ()


def do_side_by_side(tasks, bar):
    """Do tasks, as :func:`eval.runs.local.do_here` does them one after another.

    Those whose method is to be ``alone`` are done one after another, on all threads: beside others
    their times would be those of a busy machine. So are all where processes cannot be forked
    safely, since this process has other threads or the system is not Linux, and those that are left
    when a process is killed, as where memory is short.
    """
    together = [task for task in tasks if not _is_alone(task)]
    # The longest begin first, so that no process has a long one left when the others are done.
    together.sort(key=lambda task: -task.job.cost)
    alone = [task for task in tasks if _is_alone(task)]
    processes = min(possible_processes(), len(together), MOST)
    if processes > 1:
        left = dict(enumerate(together))
        for number, outcome in _in_processes(together, processes, bar):
            yield left.pop(number), outcome
        together = list(left.values())
    yield from do_here(together + alone, bar)


def _is_alone(task):
    return getattr(task.job.method, "alone", False)


def _in_processes(tasks, processes, bar):
    """Give the number of each task that is done, and its outcome."""
    pool = ProcessPoolExecutor(
        processes, multiprocessing.get_context("fork"), _begin, (tuple(tasks),)
    )
    try:
        with forking():
            futures = {pool.submit(_work, number): number for number in range(len(tasks))}
        for future in as_completed(list(futures)):
            number = futures.pop(future)  # else results would be kept until the last is there
            bar.set_description_str(tasks[number].job.title)
            try:
                outcome = future.result()
            except BrokenProcessPool:
                continue
            except Exception as error:
                outcome = error
            del future
            yield number, outcome
            bar.update(tasks[number].job.cost)
    except BaseException:
        for process in multiprocessing.active_children():
            process.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _begin(tasks):
    """A process begins. Ctrl-C is for the process that gives it work, and it ends with that one."""
    global _tasks
    _tasks = tasks
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    numba.set_num_threads(1)
    threadpool_limits(1)  # of NumPy's linear algebra


def _work(number):
    return work(_tasks[number].job, _tasks[number].metrics)
