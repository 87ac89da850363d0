"""How long an iteration takes on one thread and on two, and what two can gain on this machine."""

import time

import numpy as np
import pandas as pd
from numba import prange

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


def timing(exemplar, shapes):
    """Milliseconds of an iteration of the paper's settings, from white noise.

    Parameters
    ----------
    exemplar : (H, W) or (H, W, c) uint8
    shapes : sequence of (int, int)
        The size of S and R of each row.

    Returns
    -------
    pandas.DataFrame
        Medians of several runs, of one thread and of two in turns. A thread more than there are
        counts as the last.
    """
    rows = []
    for size, radius in shapes:
        params = TextureParams.preset("paper", radius=radius)
        _iterations(exemplar, size, params, 1)  # compiled first
        runs = {threads: [] for threads in THREADS}
        for _ in range(REPEATS):
            for threads in THREADS:
                runs[threads].append(_iterations(exemplar, size, params, threads))
        row = {"size of S": size, "R": radius}
        late = {}
        for threads, milliseconds in runs.items():
            name = "1 thread" if threads == 1 else f"{threads} threads"
            row[f"{name}, 1 to 16 [ms]"] = np.median(np.mean(milliseconds, axis=1))
            late[threads] = np.median(np.mean(milliseconds, axis=1, where=_is_late(params)))
            row[f"{name}, 11 to 16 [ms]"] = late[threads]
        rows.append(row | {"times as fast": late[1] / late[2]})
    return pd.DataFrame(rows).round(2)


def ceiling():
    """What two threads gain where nothing but memory or arithmetic holds them up.

    Returns
    -------
    pandas.DataFrame
        The least times of several, one thread and two in turns.
    """
    source = np.ones(_COPIED // 8)
    copied, sums = source.copy(), np.zeros(64, np.uint32)
    works = {
        "a plain copy of 64 MB": lambda: _copy(source.reshape(64, -1), copied.reshape(64, -1)),
        "arithmetic alone": lambda: _compute(sums, _STEPS // sums.size),
    }
    rows = []
    for name, work in works.items():
        work()  # compiled first
        least = dict.fromkeys(THREADS, np.inf)
        for _ in range(REPEATS):
            for threads in THREADS:
                with using_threads(threads):
                    begun = time.perf_counter()
                    work()
                    least[threads] = min(least[threads], 1000 * (time.perf_counter() - begun))
        rows.append(
            {
                "work": name, "1 thread [ms]": least[1], "2 threads [ms]": least[2],
                "times as fast": least[1] / least[2],
            }
        )  # fmt: skip
    return pd.DataFrame(rows).round(2)


def _iterations(exemplar, size, params, threads):
    with using_threads(threads):
        session = TextureSession([exemplar], (size, size), params)
        clock = [time.perf_counter()]
        for _ in range(params.iterations):
            session.step()
            clock.append(time.perf_counter())
    return 1000 * np.diff(clock)


def _is_late(params):
    return np.arange(params.iterations) >= LATE


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
