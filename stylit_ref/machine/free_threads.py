"""Whether frames are faster with all threads or with one at the moment.

Threads of a kernel wait for each other. Beside other busy programs one of them has to wait for a
processor first, and the rest for it: a frame then takes several times as long as with one thread.
"""

from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from time import perf_counter, thread_time

from stylit_ref.machine.forks import available_threads
from stylit_ref.machine.thread_count import using_threads

_WORTH = 0.8
"""All threads are taken again when a frame takes less than this part of one thread's time."""

_REFRESH = 4.0  # seconds after which one thread's time is measured again
_SHORTEST, _LONGEST = 0.1, 1.0  # seconds until all threads are tried again
_DISTURBED = 8.0  # the same in seconds while even one thread has to wait for a processor
_WINDOW = 0.25  # seconds of frames that tell whether it has


class FreeThreads:
    """Lets frames run with all threads or with one, whichever was faster of late.

    Now and then a single frame tries the other way. With one thread a frame's own processor time
    tells how long it waited: as long as it does, other programs are busy, and trials are rare.

    Parameters
    ----------
    clock, own_clock : callable
        Seconds, and those that this thread had a processor.
    """

    def __init__(
        self,
        clock: Callable[[], float] = perf_counter,
        own_clock: Callable[[], float] = thread_time,
    ) -> None:
        self._clock, self._own_clock = clock, own_clock
        self._uses_all = True
        self._seconds: dict[Hashable, dict[bool, float]] = {}
        self._next_trial = 0.0
        self._pause = _SHORTEST
        self._is_disturbed = False
        self._wall = self._own = 0.0

    @property
    def number(self) -> int:
        """How many threads are the better choice: all, or 1."""
        return available_threads() if self._uses_all else 1

    def forget(self) -> None:
        """Tell that frames take another time from now on."""
        self._seconds.clear()

    @contextmanager
    def frame(self, kind: Hashable) -> Iterator[None]:
        """Compute a frame in the block, with the better number of threads or as a trial.

        Parameters
        ----------
        kind : hashable
            Frames of one kind take about as long as each other.
        """
        if available_threads() == 1:
            yield
            return
        begun, own = self._clock(), self._own_clock()
        seconds = self._seconds.setdefault(kind, {})
        is_trial = self._is_trial_due(seconds, begun)
        with_all = self._uses_all != is_trial
        with using_threads(available_threads() if with_all else 1):
            yield
        now = self._clock()
        seconds[with_all] = now - begun
        if not with_all:
            self._watch(now - begun, self._own_clock() - own)
        if len(seconds) == 2 and (is_trial or with_all):
            self._choose(seconds, now, is_trial)

    def _is_trial_due(self, seconds, now):
        if self._uses_all not in seconds:
            return False  # there is nothing to compare with
        if self._uses_all and False not in seconds:
            return True
        return now >= self._next_trial + (_DISTURBED if self._is_disturbed else 0)

    def _watch(self, wall, own):
        self._wall, self._own = self._wall + wall, self._own + own
        if self._wall >= _WINDOW:
            self._is_disturbed = self._own < 0.9 * self._wall
            self._wall = self._own = 0.0

    def _choose(self, seconds, now, is_trial):
        used_all = self._uses_all
        self._uses_all = seconds[True] < (1 if used_all else _WORTH) * seconds[False]
        if self._uses_all:
            self._is_disturbed = False
            if is_trial:
                self._next_trial = now + _REFRESH
        else:
            self._pause = _SHORTEST if used_all else min(2 * self._pause, _LONGEST)
            self._next_trial = now + self._pause
