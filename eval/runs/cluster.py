"""Do runs on a Dask cluster."""

import threading
import time
from contextlib import contextmanager

from eval.runs.job import Job
from eval.runs.local import work
from stylit_ref import InputError

RETRIES = 2
"""How often a failed run on a cluster is tried again."""

PATIENCE = "30s"
"""Seconds that a scheduler may take to answer."""


def do_on_cluster(tasks, scheduler, bar):
    """Do tasks on a cluster, as :func:`eval.runs.local.do_here` does them here.

    Parameters
    ----------
    tasks : sequence of Task
    scheduler : str
        Address.
    bar : tqdm.tqdm

    Raises
    ------
    InputError
        If no scheduler answers at the address.
    """
    from dask.distributed import as_completed

    with _client(scheduler) as client:
        scenes = {task.job.scene.digest: None for task in tasks}
        for task in tasks:
            scene = task.job.scene
            if scenes[scene.digest] is None:
                scenes[scene.digest] = client.scatter(scene, broadcast=True)
        futures = {}
        for task in tasks:
            job = task.job
            future = client.submit(
                _work_of, scenes[job.scene.digest], job.method, job.seed, job.place, task.metrics,
                key=f"run-{job.key}-{time.time()}", retries=RETRIES,
            )  # fmt: skip
            futures[future] = task
        for future in as_completed(futures):
            task = futures[future]
            bar.set_description_str(task.job.title)
            try:
                key, *outcome = future.result()
                if key != task.job.key:
                    raise RuntimeError("the worker runs different code; update its checkout")
            except Exception as error:
                outcome = error
            yield task, outcome
            bar.update(task.job.cost)
            future.release()


_ALONE = threading.Lock()
"""One run at a time: a kernel uses all processors, and some threading layers allow one caller."""


def _work_of(scene, method, seed, place, metrics):
    job = Job(scene, method, seed, place)
    with _ALONE:
        return job.key, *work(job, metrics)


@contextmanager
def _client(scheduler):
    try:
        from dask.distributed import Client
    except ImportError:
        raise InputError("--scheduler needs Dask; pip install -e '.[cluster]'") from None
    try:
        client = Client(scheduler, timeout=PATIENCE)
    except (OSError, ValueError) as error:
        raise InputError(f"--scheduler {scheduler} does not answer: {error}") from None
    try:
        yield client
    finally:
        client.close()
