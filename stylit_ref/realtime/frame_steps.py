"""A frame that is made step by step, to be looked at on its way."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.realtime.refinement import Operation, refining, start_level, threads_of_level
from stylit_ref.realtime.session import Session


class FrameSteps:
    """The operations of a cold frame; after the last of them the picture is that frame.

    The session must neither change nor compute another frame meanwhile: the steps use its images.
    It does not learn of the frame.

    Parameters
    ----------
    session : Session
        With a source and a target; its seed counts.

    Attributes
    ----------
    upcoming : Operation or None
        What :meth:`advance` does; None when the frame is finished.
    done : Operation or None
        What it did last.

    Raises
    ------
    InputError
        If the session has no source or no target.
    """

    upcoming: Operation | None
    done: Operation | None

    def __init__(self, session: Session) -> None:
        self._session, self._inputs = session, session.inputs
        self._nnf = [np.empty(grid, np.int32) for grid in self._inputs.target.grids]
        self._operations = self._all()
        self.upcoming, self.done = next(self._operations), None

    def advance(self) -> Operation:
        """Do the operation that comes next.

        Returns
        -------
        Operation

        Raises
        ------
        InputError
            If the frame is finished.
        """
        operation = self.upcoming
        if operation is None:
            raise InputError("the frame is finished; restart it")
        threads = threads_of_level(self._inputs.target, operation.level)
        with self._session.turn(), using_threads(threads):
            self.upcoming = next(self._operations, None)
        self.done = operation
        return operation

    def picture(self) -> NDArray[np.uint8]:
        """B' of the level that the last operation worked on, from its matches as they are.

        Returns
        -------
        (height, width, 3) uint8

        Raises
        ------
        InputError
            If no operation is done.
        """
        if self.done is None:
            raise InputError("no step of the frame is done yet; do one first")
        nnf = self._nnf[self.done.level]
        with self._session.turn():
            if self.upcoming is None and self._session.params.dense_finish:
                return self._inputs.voted(self._inputs.dense_nnf(nnf))
            return self._inputs.blended(nnf, self.done.level)

    def _all(self) -> Iterator[Operation]:
        exemplar, target, refinement, _ = self._inputs
        seed, stop = self._session.seed, np.zeros(1, np.uint8)
        for level in reversed(range(self._session.params.levels)):
            yield Operation("upsample", level, 0)
            start_level(exemplar, self._nnf, level, seed)
            yield from refining(exemplar, target, refinement, self._nnf, level, seed, stop)
        # The picture is blended when it is asked for.
        yield Operation("blend", 0, self._session.params.iterations_at(0))
