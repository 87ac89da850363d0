"""Do runs on this machine, one after another."""

import io

from eval.metrics import METRICS
from eval.runs.store import encoded, measure, read, run_file, store, store_numbers, stored


def run(job, progress=None):
    """Do a run, or read its stored result.

    Parameters
    ----------
    job : Job
    progress : callable, optional
        As for :func:`stylit_ref.stylize`.

    Returns
    -------
    Run
    """
    result = stored(job)
    if result is None:
        store(job, compute(job, progress))
        result = stored(job)
    return result


def numbers(job, metrics=tuple(METRICS)):
    """Do a run and measure it, or read its stored numbers.

    Parameters
    ----------
    job : Job
    metrics : sequence of str
        Names of :data:`eval.metrics.METRICS`.

    Returns
    -------
    dict of str to float
        By the names of :data:`eval.metrics.NUMBERS`.
    """
    found = measure(job, run(job), metrics)
    store_numbers(job, found)
    return {name: value for part in found.values() for name, value in part.items()}


def compute(job, progress=None):
    """Do a run; returns the bytes that :func:`eval.runs.store.store` takes."""
    return encoded(job, job.method.run(job.scene, job.seed, progress))


def work(job, metrics=tuple(METRICS), progress=None):
    """Do a run, unless it is stored, and measure it.

    Parameters
    ----------
    job : Job
    metrics : sequence of str
    progress : callable, optional
        As for :func:`stylit_ref.stylize`.

    Returns
    -------
    bytes, dict
        For :func:`eval.runs.store.store` and :func:`eval.runs.store.store_numbers`.
    """
    result = run_file(job).read_bytes() if stored(job) else compute(job, progress)
    return result, measure(job, read(io.BytesIO(result)), metrics)


def do_here(tasks, bar):
    """Do tasks one after another.

    Parameters
    ----------
    tasks : sequence of Task
    bar : tqdm.tqdm
        It counts their costs.

    Yields
    ------
    Task, and what :func:`work` returns or the exception it ended with
    """
    done = bar.n
    for task in tasks:
        cost = task.job.cost

        def show(step, done=done, cost=cost):
            bar.update(done + cost * step.done - bar.n)

        bar.set_description_str(task.job.title)
        try:
            yield task, work(task.job, task.metrics, show)
        except Exception as error:
            yield task, error
        done += cost
        bar.update(done - bar.n)
