"""How many threads find a processor of their own at the moment.

Threads of a kernel wait for each other. Beside other busy programs one of them has to wait for a
processor first, and the rest for it: a frame then takes several times as long as with one thread.
"""

from time import perf_counter

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.forks import available_threads
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.thread_count import using_threads

_MEETINGS = 8
_PATIENCE = 3.0
"""A meeting of all threads that takes so many times what it does with one thread is disturbed."""


@kernel(nogil=True)
def _meet(work: NDArray[np.int64], rounds: int) -> None:
    for k in prange(work.size):
        state = work[k]
        for _ in range(rounds):
            state = state * 6364136223846793005 + 1442695040888963407
        work[k] = state


class FreeThreads:
    """Finds out now and then whether all threads have a processor.

    Parameters
    ----------
    calm, busy : float
        Seconds between two looks while all threads are used, and while one is.
    """

    def __init__(self, calm: float = 0.1, busy: float = 0.4) -> None:
        self._pause = {True: calm, False: busy}
        self._are_free = True
        self._next = 0.0
        self._usual = float("inf")

    def number(self) -> int:
        """All threads, or 1 if another program needs their processors."""
        available = available_threads()
        if available == 1:
            return 1
        now = perf_counter()
        if now >= self._next:
            self._are_free = self._look(available)
            self._next = perf_counter() + self._pause[self._are_free]
        return available if self._are_free else 1

    def took(self, threads: int, seconds: float) -> None:
        """Tell how long a frame took; after a slow one with all threads a look is due at once."""
        if threads > 1:
            if seconds > 1.5 * self._usual:
                self._next = 0.0
            self._usual = min(seconds, 1.1 * self._usual)

    def _look(self, available):
        """Whether threads that have little to do meet in the time that the work takes."""
        work = np.zeros(available, np.int64)
        times = []
        for threads in (1, available):
            with using_threads(threads):
                _meet(work, 1)  # wakes them
                start = perf_counter()
                for _ in range(_MEETINGS):
                    _meet(work, 8000 * threads // available)
                times.append(perf_counter() - start)
        return times[1] < _PATIENCE * times[0]
