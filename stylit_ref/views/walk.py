"""Walk a plan in one process: read states, make those that are missing, and keep them."""

from collections.abc import Callable, Iterator

from stylit_ref.machine.thread_count import using_threads
from stylit_ref.views.frame_step import FrameStep
from stylit_ref.views.keys import keys_of
from stylit_ref.views.params import SEQUENTIAL
from stylit_ref.views.plan import Task
from stylit_ref.views.problem import Problem
from stylit_ref.views.state import State
from stylit_ref.views.work_folder import WorkFolder
from stylit_ref.views.workbench import Workbench


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
    threads : int, optional
    """

    def __init__(
        self, problem: Problem, folder: WorkFolder, bench: Workbench, threads: int | None = None
    ) -> None:
        self._problem, self._folder, self._bench = problem, folder, bench
        self._threads, self._plan = threads, problem.plan()
        self._keys = keys_of(problem, self._plan)

    def run(
        self, progress: Callable[[FrameStep], None] | None = None
    ) -> Iterator[tuple[int, State]]:
        """Do all that is missing.

        Parameters
        ----------
        progress : callable, optional

        Yields
        ------
        tuple of int and State
            Each frame when it is finished.
        """
        finished: set[int] = set()
        whole = sum(map(_cost, self._plan.tasks()))
        while len(finished) < len(self._plan.frames):
            missing = self.missing()
            for frame in self._plan.frames:
                state = None if frame in finished else self._state(self._plan.last(frame))
                if state:
                    finished.add(frame)
                    yield frame, state
            left = sum(map(_cost, missing))
            for task in missing:
                state = self.do(task)
                if state is None:
                    break
                left -= _cost(task)
                if progress:
                    progress(self._step(task, 1 - left / whole))
                if task == self._plan.last(task.frame):
                    self._bench.forget(task.frame)
                    if self._plan.order == SEQUENTIAL:
                        self._forget_all_but_last(task.frame)
                    if task.frame not in finished:
                        finished.add(task.frame)
                        yield task.frame, state
        for frame in self._plan.frames:
            self._forget_all_but_last(frame)

    def missing(self) -> list[Task]:
        """The tasks to do until all frames are finished, in their order."""
        return self._plan.missing(lambda task: self._state(task) is not None)

    def do(self, task: Task) -> State | None:
        """Do a task, and keep its state.

        Returns
        -------
        State or None
            None if a state that it reads is missing: it was damaged or removed meanwhile.
        """
        before = self._plan.before(task)
        own = None if before is None else self._state(before)
        if before is not None and own is None:
            return None
        pictures = {}
        for other in self._plan.pulling(task):
            pulling = self._state(other)
            if pulling is None:
                return None
            pictures[other.frame] = pulling.picture
        with using_threads(self._threads):
            state = self._bench.make(task, own, pictures)
        self._folder.put(self._keys[task], state)
        older = before and self._plan.before(before)
        if older:
            self._folder.forget(self._keys[older])
        return state

    def _state(self, task):
        return self._folder.get(self._keys[task])

    def _forget_all_but_last(self, frame):
        task = self._plan.last(frame)
        while task := self._plan.before(task):
            self._folder.forget(self._keys[task])

    def _step(self, task, done):
        return FrameStep(
            frame=task.frame,
            frames=len(self._plan.frames),
            name=self._problem.shot.names[task.frame],
            level=task.level,
            levels=len(self._plan.votes),
            vote=task.vote,
            votes=self._plan.votes[task.level - 1],
            done=done,
        )


def _cost(task):
    """How much work a task is: levels have four times the pixels of those before them."""
    return 4.0**task.level if task.vote else 0.0
