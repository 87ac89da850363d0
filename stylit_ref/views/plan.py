"""The order of work: which state of a frame is made of which others."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import NamedTuple

from stylit_ref.views.params import PARALLEL, SEQUENTIAL, SWEEPS


class Task(NamedTuple):
    """The making of one state of a frame.

    Attributes
    ----------
    frame : int
    level : int
        1 is the coarsest.
    vote : int
        The search-vote iteration, from 1; 0 begins the level.
    """

    frame: int
    level: int
    vote: int


class Plan:
    """The tasks of all frames, and the states that each reads.

    Parameters
    ----------
    neighbours : sequence of sequence of int
        For every frame those that pull at it.
    votes : sequence of int
        Search-vote iterations of every level, the coarsest first.
    order : {"parallel", "sweeps", "sequential"}
    following_votes : sequence of int, optional
        In ``sequential`` order those of frames at which others pull; ``votes`` by default.

    Attributes
    ----------
    neighbours, votes, order
        As given.
    following_votes : sequence of int
    """

    neighbours: Sequence[Sequence[int]]
    votes: Sequence[int]
    order: str
    following_votes: Sequence[int]

    def __init__(
        self,
        neighbours: Sequence[Sequence[int]],
        votes: Sequence[int],
        order: str,
        following_votes: Sequence[int] | None = None,
    ) -> None:
        self.neighbours, self.votes, self.order = neighbours, votes, order
        self.following_votes = votes if following_votes is None else following_votes

    @property
    def frames(self) -> range:
        """Numbers of the frames."""
        return range(len(self.neighbours))

    def tasks(self) -> Iterator[Task]:
        """All tasks, each behind those that it reads."""
        if self.order == SEQUENTIAL:
            for frame in self.frames:
                for level, vote in _iterations(self.votes_of(frame)):
                    yield Task(frame, level, vote)
            return
        for level, vote in _iterations(self.votes):
            back = self.order == SWEEPS and vote > 0 and vote % 2 == 0
            for frame in self.frames[:: -1 if back else 1]:
                yield Task(frame, level, vote)

    def votes_of(self, frame: int) -> Sequence[int]:
        """Search-vote iterations of every level of a frame, the coarsest first."""
        follows = self.order == SEQUENTIAL and self.neighbours[frame]
        return self.following_votes if follows else self.votes

    def last(self, frame: int) -> Task:
        """The task that finishes a frame."""
        return Task(frame, len(self.votes), self.votes_of(frame)[-1])

    def before(self, task: Task) -> Task | None:
        """The task whose state this one changes, or None for the first of a frame."""
        if task.vote:
            return task._replace(vote=task.vote - 1)
        if task.level == 1:
            return None
        return Task(task.frame, task.level - 1, self.votes_of(task.frame)[task.level - 2])

    def pulling(self, task: Task) -> list[Task]:
        """The tasks whose pictures pull at this one, one of each neighbour."""
        others = self.neighbours[task.frame] if task.vote else ()
        if self.order == SEQUENTIAL:
            return [self.last(other) for other in others]
        return [
            Task(other, task.level, task.vote - (not self._is_ahead(task, other)))
            for other in others
        ]

    def reads(self, task: Task) -> list[Task]:
        """All tasks whose states this one reads."""
        before = self.before(task)
        return self.pulling(task) + ([] if before is None else [before])

    def removed_by(self, task: Task) -> Task | None:
        """The task whose state nobody needs any more when this one is done, if there is one."""
        before = self.before(task)
        return before and self.before(before)

    def waits(self, tasks: Iterable[Task]) -> dict[Task, set[Task]]:
        """For each of some tasks those that it waits for where several are done at a time.

        They are the tasks that it reads, and the readers of the state that goes when it is done: a
        frame may pull at one that does not pull at it.
        """
        tasks = list(tasks)
        readers: dict[Task | None, set[Task]] = {}
        for task in tasks:
            for read in self.reads(task):
                readers.setdefault(read, set()).add(task)
        return {
            task: {*self.reads(task), *readers.get(self.removed_by(task), ())} - {task}
            for task in tasks
        }

    def missing(self, has: Callable[[Task], bool]) -> list[Task]:
        """The tasks to do until all frames are finished, in their order.

        Parameters
        ----------
        has : callable
            Whether the state of a task is there.
        """
        found, waiting = set(), [self.last(frame) for frame in self.frames]
        while waiting:
            task = waiting.pop()
            if task not in found and not has(task):
                found.add(task)
                waiting += self.reads(task)
        return [task for task in self.tasks() if task in found]

    def _is_ahead(self, task, other):
        """Whether the other frame has done this iteration when the task begins."""
        if self.order == PARALLEL:
            return False
        return other < task.frame if task.vote % 2 else other > task.frame


def _iterations(votes):
    for level, count in enumerate(votes, 1):
        for vote in range(count + 1):
            yield level, vote
