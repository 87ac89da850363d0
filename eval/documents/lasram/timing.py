"""How long an iteration takes on one thread and on two, and what two can gain on this machine."""

import time
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numba import prange

from eval.on_processor import OnProcessor
from eval.outcome import Outcome
from eval.runs.store import stored
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession

THREADS = 1, 2
REPEATS = 3
LATE = 10
"""Iterations 11 to 16 are the late ones."""

_COPIED = 64 << 20
_STEPS = 20_000_000


@dataclass(frozen=True)
class ThreadTimes(OnProcessor):
    """Iterations of the paper's settings from white noise, on one thread and on two in turns.

    Attributes
    ----------
    radius : int
        R.
    """

    radius: int

    cost = 100.0
    alone = True

    @property
    def name(self):
        """What reports call it."""
        return f"on one thread and on two, R = {self.radius}"

    def run(self, texture, seed, progress=None):
        """Do the iterations, several times.

        Parameters
        ----------
        texture : Texture
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The history has ``milliseconds`` by ``threads``, ``repeat`` and ``iteration``, these
            from 1.
        """
        params = TextureParams.preset("paper", radius=self.radius)
        _synthesized(texture, params, seed, 1)  # compiled first
        begun, rows = time.perf_counter(), []
        for repeat in range(REPEATS):
            for threads in THREADS:
                image, times = _synthesized(texture, params, seed, threads)
                rows += [
                    {"threads": threads, "repeat": repeat, "iteration": k, "milliseconds": each}
                    for k, each in enumerate(times, 1)
                ]
        return Outcome(image, time.perf_counter() - begun, history=pd.DataFrame(rows))


@dataclass(frozen=True)
class Ceiling(OnProcessor):
    """Work that nothing but memory or arithmetic holds up, on one thread and on two in turns."""

    name = "what threads can gain"
    cost = 1.0
    alone = True

    def run(self, texture, seed, progress=None):
        """Do the work, several times.

        Parameters
        ----------
        texture : Texture
            Its exemplar is the image of the outcome.
        seed : int
            Not used.
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The history has ``milliseconds`` by ``work``, ``threads`` and ``repeat``.
        """
        source = np.ones(_COPIED // 8)
        copied, sums = source.copy(), np.zeros(64, np.uint32)
        works = {
            "a plain copy of 64 MB": lambda: _copy(source.reshape(64, -1), copied.reshape(64, -1)),
            "arithmetic alone": lambda: _compute(sums, _STEPS // sums.size),
        }
        begun, rows = time.perf_counter(), []
        for name, work in works.items():
            work()  # compiled first
            for repeat in range(REPEATS):
                for threads in THREADS:
                    row = {"work": name, "threads": threads, "repeat": repeat}
                    with using_threads(threads):
                        before = time.perf_counter()
                        work()
                        row["milliseconds"] = 1000 * (time.perf_counter() - before)
                    rows.append(row)
        seconds = time.perf_counter() - begun
        return Outcome(texture.exemplar, seconds, history=pd.DataFrame(rows))


def timing(jobs):
    """Milliseconds of an iteration, a row for each run of :class:`ThreadTimes`.

    Parameters
    ----------
    jobs : sequence of Job

    Returns
    -------
    pandas.DataFrame
        Medians of several repeats, on one thread and on two. A thread more than there are counts as
        the last.
    """
    rows = []
    for job in jobs:
        times = stored(job).history
        every = _medians(times)
        late = _medians(times[times["iteration"] > LATE])
        row = {"size of S": job.scene.shape[0], "R": job.method.radius}
        for threads in THREADS:
            name = "1 thread" if threads == 1 else f"{threads} threads"
            row[f"{name}, 1 to 16 [ms]"] = every[threads]
            row[f"{name}, 11 to 16 [ms]"] = late[threads]
        rows.append(row | {"times as fast": late[1] / late[2]})
    return pd.DataFrame(rows).round(2)


def ceiling(job):
    """What two threads gain where nothing but memory or arithmetic holds them up.

    Parameters
    ----------
    job : Job
        A run of :class:`Ceiling`.

    Returns
    -------
    pandas.DataFrame
        The least times of several.
    """
    times = stored(job).history
    least = times.groupby(["work", "threads"], sort=False)["milliseconds"].min().unstack()
    rows = [
        {
            "work": work, "1 thread [ms]": one, "2 threads [ms]": two, "times as fast": one / two,
        }
        for work, one, two in least[list(THREADS)].itertuples()
    ]  # fmt: skip
    return pd.DataFrame(rows).round(2)


def _medians(times):
    """The median repeat's mean iteration, by the number of threads."""
    means = times.groupby(["threads", "repeat"])["milliseconds"].mean()
    return means.groupby("threads").median()


def _synthesized(texture, params, seed, threads):
    """A texture, and the milliseconds of each of its iterations."""
    with using_threads(threads):
        session = TextureSession([texture.exemplar], texture.shape, params, seed=seed)
        clock = [time.perf_counter()]
        for _ in range(params.iterations):
            session.step()
            clock.append(time.perf_counter())
    return session.image, 1000 * np.diff(clock)


@kernel()
def _copy(source, copied):
    for row in prange(source.shape[0]):
        copied[row] = source[row]


@kernel()
def _compute(sums, steps):
    for k in prange(sums.size):
        word = np.uint32(k + 1)
        for _ in range(steps):  # each step needs the one before: nothing is left out
            word ^= np.uint32(word << 13)
            word ^= word >> np.uint32(17)
            word ^= np.uint32(word << 5)
        sums[k] = word
