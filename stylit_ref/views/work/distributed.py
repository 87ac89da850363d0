"""Walk a plan on a Dask cluster, whose machines share the work folder and nothing else."""

import secrets
import threading
from collections.abc import Generator, Iterator, Mapping, Sequence
from concurrent.futures import CancelledError
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from itertools import groupby
from typing import Any

from stylit_ref.errors import InputError
from stylit_ref.views.params import SEQUENTIAL
from stylit_ref.views.plan import Plan, Task
from stylit_ref.views.problem import Problem
from stylit_ref.views.work.keys import code_key
from stylit_ref.views.work.walk import Walk
from stylit_ref.views.work.work_folder import WorkFolder
from stylit_ref.views.work.workbench import Workbench

RETRIES = 2
"""How often a task that fails is tried again."""

PATIENCE = "30s"
"""How long a scheduler may take to answer."""


@dataclass(frozen=True, eq=False)
class Job:
    """What every machine has to know.

    Attributes
    ----------
    problem : Problem
    folder : str
        The work folder, by a path that all machines know.
    keys : mapping of Task to str
    threads : int, optional
        Of each process.
    code : str
        What :func:`stylit_ref.views.work.keys.code_key` was when the keys were made.
    """

    problem: Problem
    folder: str
    keys: Mapping[Task, str]
    threads: int | None
    code: str


def do_on_cluster(job: Job, scheduler: str, missing: Sequence[Task]) -> Generator[Task, None, None]:
    """Do tasks on a cluster; :meth:`stylit_ref.views.work.walk.Walk.do_here` does them here.

    What runs on a machine is one search-vote iteration of a frame. In parallel order it begins when
    the frame and its neighbours have done the iteration before. In sequential order it is a whole
    frame, which begins when the one before is finished.

    Parameters
    ----------
    job : Job
    scheduler : str
        Address of a Dask scheduler, as ``tcp://10.0.0.1:8786``.
    missing : sequence of Task
        In the order of the plan.

    Yields
    ------
    Task
        Each when it is done. It ends early if a state has gone missing, or what machines know.

    Raises
    ------
    InputError
        If Dask is not installed, or no scheduler answers at the address.
    """
    plan, run = job.problem.plan(), secrets.token_hex(4)
    with _client(scheduler) as client:
        from dask.distributed import KilledWorker, as_completed

        waits = plan.waits(missing)
        everywhere = client.scatter(job, broadcast=True, hash=False)
        futures: dict[Task, Any] = {}
        bundles: dict[Any, list[Task]] = {}
        for bundle in _bundles(plan, missing):
            first = {each for task in bundle for each in waits[task]}
            after = {futures[each] for each in first & futures.keys()}
            future = client.submit(
                _do, everywhere, bundle, list(after),
                key=f"state-{job.keys[bundle[-1]]}-{run}", retries=RETRIES,
            )  # fmt: skip
            futures.update(dict.fromkeys(bundle, future))
            bundles[future] = bundle
        try:
            for future in as_completed(list(bundles)):
                if not future.result():
                    return
                yield from bundles[future]
        except KilledWorker:
            raise InputError(
                f"{scheduler} lost its machines again and again, perhaps for want of memory; take "
                "larger ones, or fewer processes on each",
                parameter="scheduler",
            ) from None
        except CancelledError:  # the last machine that knew the job is gone: tell the others anew
            return
        finally:
            client.cancel(list(bundles))


def _bundles(plan: Plan, missing: Sequence[Task]) -> Iterator[list[Task]]:
    """The tasks that are done in one place, one after the other."""
    if plan.order == SEQUENTIAL:
        for _, tasks in groupby(missing, lambda task: task.frame):
            yield list(tasks)
    else:
        yield from ([task] for task in missing)


_ALONE = threading.Lock()
"""One task at a time in each process: kernels have all of its threads."""


def _do(job: Job, bundle: Sequence[Task], after: Sequence[bool]) -> bool:
    """Do tasks on a machine of the cluster; returns whether all that they read was there."""
    if not all(after):
        return False
    with _ALONE:
        walk = _walk(job)
        return all(walk.do(task) for task in bundle)


@lru_cache(maxsize=1)
def _walk(job):
    if job.code != code_key(job.problem.shot):
        raise InputError("a machine of the cluster runs other code; install the same on all")
    return Walk(job.problem, WorkFolder(job.folder), Workbench(job.problem), job.keys, job.threads)


@contextmanager
def _client(scheduler):
    try:
        from dask.distributed import Client
    except ImportError:
        raise InputError(
            "needs Dask; pip install 'stylit-ref[cluster]'", parameter="scheduler"
        ) from None
    try:
        client = Client(scheduler, timeout=PATIENCE)
    except (OSError, ValueError) as error:
        raise InputError(f"{scheduler} does not answer: {error}", parameter="scheduler") from None
    try:
        client.wait_for_workers(1, timeout=PATIENCE)
    except TimeoutError:
        client.close()
        raise InputError(
            f"{scheduler} has no workers; start some with 'dask worker {scheduler}'",
            parameter="scheduler",
        ) from None
    try:
        yield client
    finally:
        client.close()
