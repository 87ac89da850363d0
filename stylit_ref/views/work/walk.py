"""Walk a plan in one process: read states, make those that are missing, and keep them."""

from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import closing

from stylit_ref.machine.thread_count import using_threads
from stylit_ref.views.frame_step import FrameStep
from stylit_ref.views.params import SEQUENTIAL
from stylit_ref.views.plan import Plan, Task
from stylit_ref.views.problem import Problem
from stylit_ref.views.work.behind import Behind
from stylit_ref.views.work.kept import Kept
from stylit_ref.views.work.state import State
from stylit_ref.views.work.work_folder import WorkFolder
from stylit_ref.views.work.workbench import Workbench

ROOM = 128 << 20
"""Bytes for states that are not read from the disk again."""


class Walk:
    """The walk of a problem's plan.

    Of every frame the states of its last two iterations are kept: the others can be made of them,
    and whoever was interrupted finds all that the next iteration reads. When all frames are
    finished, their last states are left.

    Parameters
    ----------
    problem : Problem
    folder : WorkFolder
    bench : Workbench
        Of the problem.
    keys : mapping of Task to str
        From :func:`stylit_ref.views.work.keys.keys_of`.
    threads : int, optional

    Attributes
    ----------
    plan : Plan
    """

    plan: Plan

    def __init__(
        self,
        problem: Problem,
        folder: WorkFolder,
        bench: Workbench,
        keys: Mapping[Task, str],
        threads: int | None = None,
    ) -> None:
        self._shot, self._folder, self._bench = problem.shot, folder, bench
        self._keys, self._threads, self.plan = keys, threads, problem.plan()
        self._recent, self._behind = Kept(ROOM), Behind()

    def run(
        self,
        do_all: Callable[[Sequence[Task]], Generator[Task, None, None]] | None = None,
        progress: Callable[[FrameStep], None] | None = None,
    ) -> Generator[tuple[int, State], None, None]:
        """Do all that is missing.

        Parameters
        ----------
        do_all : callable, optional
            Does tasks, yields each when it is done, and ends early if a state has gone missing;
            :meth:`do_here` by default.
        progress : callable, optional

        Yields
        ------
        tuple of int and State
            Each frame when it is finished.
        """
        do_all = do_all or self.do_here
        finished: set[int] = set()
        whole = sum(map(_cost, self.plan.tasks()))
        while len(finished) < len(self.plan.frames):
            missing = self.missing()
            left = sum(map(_cost, missing))
            waiting = set(missing)
            for frame in self.plan.frames:
                if self.plan.last(frame) not in waiting:
                    yield from self._finish(frame, finished)
            with closing(do_all(missing)) as done:  # whoever stops finds all states on the disk
                for task in done:
                    left -= _cost(task)
                    if progress:
                        progress(self._step(task, 1 - left / whole))
                    if task == self.plan.last(task.frame):
                        yield from self._finish(task.frame, finished)
        for frame in self.plan.frames:
            self._forget_all_but_last(frame)

    def missing(self) -> list[Task]:
        """The tasks to do until all frames are finished, in their order."""
        return self.plan.missing(lambda task: self._folder.get(self._keys[task]) is not None)

    def do_here(self, missing: Sequence[Task]) -> Generator[Task, None, None]:
        """Do tasks one after the other, in this process; a state is written as the next is made."""
        with Behind() as self._behind:
            for task in missing:
                if not self._make(task):
                    return
                yield task

    def do(self, task: Task) -> bool:
        """Do a task, and keep its state.

        Returns
        -------
        bool
            False if a state that it reads is missing: it was damaged or removed meanwhile.
        """
        with Behind() as self._behind:
            return self._make(task)

    def _make(self, task):
        before, pulling = self.plan.before(task), self.plan.pulling(task)
        reads = {read: self._state(read) for read in self.plan.reads(task)}
        if None in reads.values():
            return False
        pictures = {other.frame: reads[other].picture for other in pulling}
        with using_threads(self._threads):
            state = self._bench.make(task, reads[before] if before else None, pictures)
        self._recent.add(self._keys[task], state, state.nbytes)
        if task == self.plan.last(task.frame):
            self._bench.forget(task.frame)
        self._behind.do(self._keep, task, state)
        return True

    def _keep(self, task, state):
        """Write a state, and remove those that nobody needs any more."""
        if older := self.plan.removed_by(task):
            self._folder.forget(self._keys[older])
        self._folder.put(self._keys[task], state)
        if task == self.plan.last(task.frame) and self.plan.order == SEQUENTIAL:
            self._forget_all_but_last(task.frame)

    def _state(self, task):
        key = self._keys[task]
        state = self._recent.get(key)
        if state is None:
            self._behind.wait()
            state = self._folder.get(key)
        return state and self._recent.add(key, state, state.nbytes)

    def _finish(self, frame, finished):
        state = self._state(self.plan.last(frame))
        if state and frame not in finished:
            finished.add(frame)
            yield frame, state

    def _forget_all_but_last(self, frame):
        task = self.plan.last(frame)
        while task := self.plan.before(task):
            self._folder.forget(self._keys[task])

    def _step(self, task, done):
        return FrameStep(
            frame=task.frame,
            frames=len(self.plan.frames),
            name=self._shot.names[task.frame],
            level=task.level,
            levels=len(self.plan.votes),
            vote=task.vote,
            votes=self.plan.votes_of(task.frame)[task.level - 1],
            done=done,
        )


def _cost(task):
    """How much work a task is: levels have four times the pixels of those before them."""
    return 4.0**task.level if task.vote else 0.0
