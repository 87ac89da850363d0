"""Do the runs that are not stored yet, and store each as soon as it is finished."""

import traceback
from typing import NamedTuple

from tqdm import tqdm

from eval.metrics import METRICS
from eval.runs.cluster import do_on_cluster
from eval.runs.job import Job
from eval.runs.side_by_side import do_side_by_side
from eval.runs.store import store, store_numbers, stored, stored_numbers


class Task(NamedTuple):
    """A run, and the names of the metrics to measure of it."""

    job: Job
    metrics: tuple[str, ...] = tuple(METRICS)


def complete(tasks, scheduler=None):
    """Do those of some tasks whose results are not stored yet.

    Parameters
    ----------
    tasks : sequence of Task
    scheduler : str, optional
        Address of a Dask scheduler.

    Returns
    -------
    dict of str to str
        Title of every run that failed and the last line of its error, by the key of its job.
    """
    missing = [task for task in _once(tasks) if not _is_done(task)]
    if not missing:
        return {}
    failures = {}
    total = sum(task.job.cost for task in missing)
    bar_format = "{percentage:3.0f}% |{bar}| {elapsed}<{remaining}  {desc}"
    with tqdm(total=total, bar_format=bar_format, disable=None) as bar:
        finished = (
            do_on_cluster(missing, scheduler, bar) if scheduler else do_side_by_side(missing, bar)
        )
        for task, outcome in finished:
            if isinstance(outcome, BaseException):
                reason = traceback.format_exception_only(outcome)[-1].strip()
                failures[task.job.key] = f"{task.job.title}: {reason}"
            else:
                result, numbers = outcome
                store(task.job, result)
                store_numbers(task.job, numbers)
    return failures


def _is_done(task):
    return stored(task.job) is not None and stored_numbers(task.job).keys() >= set(task.metrics)


def _once(tasks):
    """Each file of a run once, with all that is to be measured of it."""
    found = {}
    for job, metrics in tasks:
        others = found[job.file_name].metrics if job.file_name in found else ()
        found[job.file_name] = Task(job, tuple(dict.fromkeys((*others, *metrics))))
    return list(found.values())
