"""A frame that a user makes step by step: one operation, an iteration or a level at a time."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.parameters import Choice
from stylit_ref.realtime.frame_steps import FrameSteps
from stylit_ref.realtime.passes.image import interior
from stylit_ref.realtime.refinement import Operation
from stylit_ref.realtime.session import Session
from stylit_ref.studio.engine.events import Stepped

OPERATIONS = Choice(("restart", "pyramid", "upsample", "half", "blend", "iteration", "level"))


class Stepper:
    """Steps of a cold frame; it ends in the picture that follows a stroke.

    Parameters
    ----------
    make_session : callable
        Makes a session of its own, which is left alone until the steps restart.
    """

    def __init__(self, make_session: Callable[[], Session]) -> None:
        self._make_session = make_session
        self._session: Session | None = None
        self._steps: FrameSteps | None = None

    @property
    def is_begun(self) -> bool:
        """Whether a step was done since it restarted."""
        return self._steps is not None

    @property
    def state(self) -> Stepped:
        """How far the frame has come."""
        if self._steps is None:
            return Stepped(0, 0, False, ("restart", "pyramid"))
        done, upcoming = self._steps.done, self._steps.upcoming
        if upcoming is None:
            return Stepped(0, done.iteration, True, ("restart",))
        level = (done or upcoming).level
        is_begun = upcoming.level == level
        iterations = upcoming.iteration if is_begun else self._session.params.iterations_at(level)
        larger = ("iteration", "level") if upcoming.name == "half" else ("level",)
        return Stepped(level, iterations, False, ("restart", upcoming.name, *larger))

    def do(self, operation: str) -> NDArray[np.uint8] | None:
        """Do an operation, or all of an iteration or a level.

        Parameters
        ----------
        operation : str
            One of :data:`OPERATIONS`.

        Returns
        -------
        (h, w, 3) uint8 or None
            After ``pyramid`` the painting on all levels, else B' of the level; None after
            ``restart``.

        Raises
        ------
        InputError
            If another operation comes next.
        """
        possible = self.state.possible
        if operation not in possible:
            raise InputError(
                f"{operation} is not what comes next; possible are {', '.join(possible)}"
            )
        if operation == "restart":
            self._steps = self._session = None
            return None
        if operation == "pyramid":
            self._session = self._make_session()
            self._steps = FrameSteps(self._session)
            return self._pyramid()
        first = self._steps.advance()
        while _belongs(operation, first, self._steps.upcoming):
            self._steps.advance()
        return self._steps.picture()

    def _pyramid(self):
        """The painting on all levels: the finest on the left, the others below each other."""
        exemplar = self._session.inputs.exemplar
        images = [interior(image, STYLE_LANES)[..., :3] for image in exemplar.style]
        finest, *coarser = images[: self._session.params.levels]
        height = max(finest.shape[0], sum(image.shape[0] for image in coarser))
        width = finest.shape[1] + max((image.shape[1] for image in coarser), default=0)
        picture = np.zeros((height, width, 3), np.uint8)
        picture[: finest.shape[0], : finest.shape[1]] = finest
        top = 0
        for image in coarser:
            rows, columns = image.shape[:2]
            picture[top : top + rows, finest.shape[1] : finest.shape[1] + columns] = image
            top += rows
        return picture


def _belongs(operation: str, first: Operation, upcoming: Operation | None) -> bool:
    """Whether what comes next is of the same iteration or level, where one is wanted as a whole."""
    if upcoming is None or upcoming.name == "upsample":
        return False
    if operation == "iteration":
        blend = "blend", first.level, first.iteration + 1
        return upcoming == blend or upcoming.iteration == first.iteration
    return operation == "level"
