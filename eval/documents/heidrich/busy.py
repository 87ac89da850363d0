"""Frames beside other busy programs, and how soon after them a session uses all threads again."""

import os
import time
from dataclasses import dataclass

import numba
import numpy as np
import pandas as pd

from eval.methods.realtime import Frames
from eval.on_processor import OnProcessor
from eval.outcome import Outcome
from eval.pages.claims import Claim, verdict
from eval.runs.busy_programs import spinning_processes
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.runs.store import stored
from eval.scenes import Scene
from stylit_ref.machine.forks import available_threads
from stylit_ref.machine.replaced import replaced
from stylit_ref.realtime import passes
from stylit_ref.realtime.params import RealtimeParams

SPINNING = 2
"""Programs that are busy without end."""

MOST_SLOWER, MOST_SECONDS = 1.3, 2.0
"""Goals: time of frames beside them over that with one thread, and seconds until all are used."""

IN_A_ROW = 5
"""Frames with all threads one after the other: fewer may be a trial."""


@dataclass(frozen=True)
class BesideOthers(OnProcessor):
    """Frames of ``best`` on a quiet machine, beside spinning processes, and after them.

    Attributes
    ----------
    seconds : float
        Of frames in each state.
    trials : int
        How often the processes start and stop.
    """

    seconds: float = 3.0
    trials: int = 2

    name = "beside others"
    cost = 20.0
    alone = True

    def run(self, scene, seed, progress=None):
        """Make the frames.

        Parameters
        ----------
        scene : Scene
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The history has a row for each trial: the ``load`` of the machine before it; medians in
            milliseconds of frames of a session that has its choice on the quiet machine
            (``quiet``), and beside the processes (``choice``), in turns with frames of ``one``
            thread; their sum over the sum of those (``slower``); and ``back``, seconds from the
            end of the processes until the session uses all threads again, infinite if it did not
            within :attr:`seconds`.
        """
        begun, params, watch = time.perf_counter(), RealtimeParams.preset("best"), Watch()
        one = Frames(scene, params, (), seed, 1)
        choice = Frames(scene, params, (), seed, None, watch.passes)
        rows = []
        for _ in range(self.trials):
            load = os.getloadavg()[0]
            (quiet,) = self._frames(choice)
            with spinning_processes(SPINNING):
                self._frames(choice)
                beside, alone = self._frames(choice, one)
            back = self._seconds_until_all(choice, watch)
            row = {"load": load, "quiet": quiet, "one": alone, "choice": beside}
            row = {name: np.median(times) for name, times in row.items()}
            rows.append(row | {"slower": sum(beside) / sum(alone), "back": back})
        return Outcome(choice.frame(), time.perf_counter() - begun, history=pd.DataFrame(rows))

    def _frames(self, *makers):
        """Milliseconds of frames, makers in turns; a list for each."""
        spent = tuple([] for _ in makers)
        end = time.perf_counter() + self.seconds
        while time.perf_counter() < end:
            for times, maker in zip(spent, makers, strict=True):
                before = time.perf_counter()
                maker.frame()
                times.append(1000 * (time.perf_counter() - before))
        return spent

    def _seconds_until_all(self, maker, watch):
        begun = time.perf_counter()
        in_a_row, first = 0, np.inf
        while time.perf_counter() < begun + self.seconds:
            before = time.perf_counter() - begun
            maker.frame()
            in_a_row = in_a_row + 1 if watch.threads == available_threads() else 0
            if in_a_row == 1:
                first = before
            if in_a_row == IN_A_ROW:
                return first
        return np.inf


class Watch:
    """Passes that tell with how many threads a session's last frame ended.

    Attributes
    ----------
    threads : int
    passes : module
    """

    def __init__(self):
        self.threads = 0
        self.passes = replaced(passes, make_blend=self._make_blend)

    def _make_blend(self, *constants):
        blend = passes.make_blend(*constants)

        def watched(*arguments):
            self.threads = numba.get_num_threads()
            blend(*arguments)

        return watched


@dataclass(frozen=True)
class Busy:
    """The section on frames beside other programs.

    Attributes
    ----------
    scene : Scene
    method : BesideOthers
    """

    scene: Scene
    method: BesideOthers = BesideOthers()

    @property
    def job(self):
        """Its run."""
        return Job(self.scene, self.method)

    @property
    def tasks(self):
        """All runs."""
        return [Task(self.job, ())]

    def claims(self):
        """What we ask of ourselves."""
        found = stored(self.job).history
        slower, back = found["slower"].max(), found["back"].max()
        return [
            Claim(
                "Other programs slow frames little, and not for long",
                "ours",
                verdict(slower <= MOST_SLOWER and back <= MOST_SECONDS),
                f"in every trial frames beside {SPINNING} spinning programs take at most "
                f"{MOST_SLOWER:g} times as long as with one thread, and all threads are used again "
                f"within {MOST_SECONDS:g} s",
                f"they take at most {slower:.2f} times as long, and all threads are back after at "
                f"most {back:.2f} s",
                of_time=True,
            )
        ]

    def sections(self, report):
        """What the page says of it."""
        table = stored(self.job).history
        return [
            "### Beside other programs",
            report.table("busy", table, table.round(2).rename(columns=_TITLES)),
            f"Medians of cold frames of `best`, {self.scene.size.replace('x', ' x ')} pixels: of a "
            f"session that has its choice, on the machine as it was, then beside {SPINNING} "
            "programs that spin, in turns with a session of one thread. *Slower* is the sum of "
            "these over the sum of those; *back* counts from the end of the programs until the "
            "session uses all threads again.",
        ]


_TITLES = {
    "load": "load before",
    "quiet": "quiet [ms]",
    "one": "beside, one thread [ms]",
    "choice": "beside, own choice [ms]",
    "back": "back [s]",
}
