"""Runs one after another here, or on a Dask cluster; every finished one is kept at once."""

import io
import threading
import time
import traceback
from collections import defaultdict
from contextlib import contextmanager

from tqdm import tqdm

from eval.image_analogies import ImageAnalogies
from eval.runs import Job, compute, read, store, stored
from eval.thesis.quality import quality, store_quality, stored_quality
from stylit_ref import InputError

RETRIES = 2
"""Times that a run on a cluster is tried again."""

PATIENCE = "30s"
"""How long a scheduler may take to answer."""

COSTS = defaultdict(lambda: 1.0, stylit=6.0)
"""Of a run, by method, in those of ``ref`` on as many pixels."""


def complete(jobs, scheduler=None):
    """Do what of some runs is not stored yet.

    Parameters
    ----------
    jobs : sequence of Job
    scheduler : str, optional
        Address of a Dask scheduler.

    Returns
    -------
    dict of str to str
        Title of every run that failed, and the last line of what went wrong.
    """
    missing = [job for job in jobs if stored_quality(job) is None or stored(job) is None]
    if not missing:
        return {}
    failures = {}
    total = sum(_cost(job) for job in missing)
    bar_format = "{percentage:3.0f}% |{bar}| {elapsed}<{remaining}  {desc}"
    with tqdm(total=total, bar_format=bar_format, disable=None) as bar:
        finish = _on_cluster(missing, scheduler, bar) if scheduler else _here(missing, bar)
        for job, outcome in finish:
            if isinstance(outcome, BaseException):
                failures[job.title] = traceback.format_exception_only(outcome)[-1].strip()
            else:
                result, numbers = outcome
                store(job, result)
                store_quality(job, numbers)
    return failures


def work(job, progress=None):
    """Run and measure a job.

    Parameters
    ----------
    job : Job
    progress : callable, optional
        As for :func:`stylit_ref.stylize`.

    Returns
    -------
    bytes, dict
        As :func:`eval.runs.store` and :func:`eval.thesis.quality.store_quality` keep them.
    """
    result = job.file.read_bytes() if stored(job) else compute(job, progress)
    return result, quality(job, read(io.BytesIO(result)))


def _here(jobs, bar):
    done = 0.0
    for job in jobs:
        cost = _cost(job)

        def show(step, done=done, cost=cost):
            bar.update(done + cost * step.done - bar.n)

        bar.set_description_str(job.title)
        try:
            yield job, work(job, show)
        except Exception as error:
            yield job, error
        done += cost
        bar.update(done - bar.n)


def _on_cluster(jobs, scheduler, bar):
    from dask.distributed import as_completed

    with _client(scheduler) as client:
        scenes = {job.scene.digest: None for job in jobs}
        for job in jobs:
            if scenes[job.scene.digest] is None:
                scenes[job.scene.digest] = client.scatter(job.scene, broadcast=True)
        futures = {
            client.submit(
                _work_of, scenes[job.scene.digest], job.params, job.seed, job.backend, job.device,
                key=f"run-{job.key}-{time.time()}", retries=RETRIES,
            ): job
            for job in jobs
        }  # fmt: skip
        for future in as_completed(futures):
            job = futures[future]
            bar.set_description_str(job.title)
            try:
                key, *outcome = future.result()
                if key != job.key:
                    raise RuntimeError("the worker runs other code than this checkout's")
            except Exception as error:
                outcome = error
            yield job, outcome
            bar.update(_cost(job))
            future.release()


_ALONE = threading.Lock()
"""Kernels use all of a worker's processors, and not every threading layer lets two threads in."""


def _work_of(scene, *rest):
    job = Job(scene, *rest)
    with _ALONE:
        return job.key, *work(job)


@contextmanager
def _client(scheduler):
    try:
        from dask.distributed import Client
    except ImportError:
        raise InputError("a scheduler needs Dask: pip install -e '.[cluster]'") from None
    try:
        client = Client(scheduler, timeout=PATIENCE)
    except (OSError, ValueError) as error:
        raise InputError(f"{scheduler}: no Dask scheduler answers there: {error}") from None
    try:
        yield client
    finally:
        client.close()


def _cost(job):
    pixels = job.scene.target_guides[0].shape[0] * job.scene.target_guides[0].shape[1]
    name = "analogies" if isinstance(job.params, ImageAnalogies) else job.params.method
    return pixels * COSTS[name]
