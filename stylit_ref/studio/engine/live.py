"""The picture that follows: one thread that computes, and a process in the background."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.parameters import Integer
from stylit_ref.studio.engine.events import Event, Problem
from stylit_ref.studio.engine.export import export
from stylit_ref.studio.engine.follower import Follower
from stylit_ref.studio.engine.looking import picture_of
from stylit_ref.studio.engine.painting import check_painting, check_rectangle
from stylit_ref.studio.engine.parameters import Settings
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.engine.stepping import OPERATIONS, Stepper
from stylit_ref.studio.engine.worker import Wanted, Worker


class Live:
    """A painting and the picture that follows it.

    All methods may be called from any thread and return at once; what comes of them is told as
    events, from threads of the engine. The newest wish wins: a stroke ends a frame and what is
    made in the background, but no rectangle of the painting is ever lost.

    Parameters
    ----------
    scene : Scene
    painting : (H_A, W_A, 3) uint8
        Of the size of the scene's source.
    tell : callable
        Called with every event.
    threads : int, optional
        Of the live frames; by default all, or one while other programs need the processors.
    seed : int

    Raises
    ------
    InputError
        If the painting does not fit the scene.
    """

    def __init__(
        self,
        scene: Scene,
        painting: NDArray[np.uint8],
        *,
        tell: Callable[[Event], None],
        threads: int | None = None,
        seed: int = 0,
    ) -> None:
        painting = check_painting(painting, scene).copy()
        self._scene, self._settings = scene, Settings(seed=seed)  # as they will be
        self._painting = painting.copy()  # likewise
        self._follower = Follower(scene, painting, self._settings, threads)
        self._stepper = Stepper(self._follower.own_session)
        self._worker = Worker(self._follower, tell)

    @property
    def settings(self) -> Settings:
        """Parameters, weights and seed."""
        return self._settings

    def paint(self, x: int, y: int, pixels: NDArray[np.uint8], serial: int) -> None:
        """Change a rectangle of the painting; a replay follows.

        Parameters
        ----------
        x, y : int
            Its left upper pixel.
        pixels : (h, w, 3) uint8
        serial : int
            Comes back with the picture that shows it.

        Raises
        ------
        InputError
            If it does not lie in the painting.
        """
        pixels = check_rectangle(x, y, pixels, self._scene.size)
        height, width = pixels.shape[:2]
        self._painting[y : y + height, x : x + width] = pixels
        self._worker.stroke(x, y, pixels, serial, self._painting)

    def rest(self) -> None:
        """The brush pauses: a coherent frame follows, then ``fast`` in the background."""
        self._worker.want_frame()

    def replace_painting(self, painting: NDArray[np.uint8], serial: int) -> None:
        """Take another painting; the rest is as after a pause of the brush.

        Raises
        ------
        InputError
            If it does not fit the scene.
        """
        painting = check_painting(painting, self._scene).copy()
        self._painting = painting.copy()
        self._worker.change(lambda: self._follower.replace_painting(painting, serial), "cold")

    def finish(self) -> None:
        """Begin the full method in the background."""
        self._worker.do(lambda: self._worker.begin("full"))

    def choose_scene(
        self, scene: Scene, painting: NDArray[np.uint8] | None = None, serial: int = 0
    ) -> None:
        """Take another scene at its first step.

        Parameters
        ----------
        scene : Scene
        painting : (H_A, W_A, 3) uint8, optional
            Another painting, where the source has another size.
        serial : int
            Of that painting.

        Raises
        ------
        InputError
            If the painting does not fit the scene.
        """
        if painting is not None:
            painting = check_painting(painting, scene).copy()
            self._painting = painting.copy()
        elif scene.size != self._scene.size:
            raise InputError(
                f"{scene.title} is painted at {scene.size[1]}x{scene.size[0]} pixels, and the "
                f"painting has {self._scene.size[1]}x{self._scene.size[0]}; begin another painting"
            )
        self._scene = scene

        def choose():
            self._follower.scene, self._follower.step = scene, 0
            if painting is not None:
                self._follower.replace_painting(painting, serial)

        self._change(choose, "cold")

    def turn(self, step: int, *, warm: bool, restylize: bool = True) -> None:
        """Take another step of the target.

        Parameters
        ----------
        step : int
        warm : bool
            Whether a frame starts from the one before, so that less flickers.
        restylize : bool
            Whether a frame follows at once, or only after :meth:`rest`.

        Raises
        ------
        InputError
            If there is no such step.
        """
        Integer(0, self._scene.steps - 1).check("step", step)
        wanted = ("warm" if warm else "cold") if restylize else None
        self._change(lambda: setattr(self._follower, "step", step), wanted)

    def set_parameters(self, values: Mapping[str, object]) -> None:
        """Change parameters: those that are not named stay.

        Parameters
        ----------
        values : mapping of str to object
            By the names of :data:`~stylit_ref.studio.engine.parameters.FIELDS`.

        Raises
        ------
        InputError
            If there is no such parameter, or a value is out of range.
        """
        self._settle(self._settings.with_parameters(values))

    def set_weights(self, values: Mapping[str, int]) -> None:
        """Weigh buffers: those that are not named stay.

        Where principal components mix the buffers, weights move the dense method alone.

        Raises
        ------
        InputError
            If there is no such buffer, or a weight is out of range.
        """
        self._settle(self._settings.with_weights(values, self._scene.buffers))

    def set_seed(self, seed: int) -> None:
        """Take another seed.

        Raises
        ------
        InputError
            If it is no integer from 0 to 2**64 - 1.
        """
        self._settle(replace(self._settings, seed=seed))

    def step(self, operation: str) -> None:
        """Do one operation, an iteration or a level of a frame; or restart it.

        Parameters
        ----------
        operation : str
            As :meth:`stylit_ref.studio.engine.stepping.Stepper.do` takes it.

        Raises
        ------
        InputError
            If there is no such operation.
        """
        OPERATIONS.check("operation", operation)
        self._worker.do(lambda: self._step(operation))

    def look(self, what: str) -> None:
        """Ask for a picture to look at.

        Parameters
        ----------
        what : str
            ``style``; ``A:LDE`` or ``B:LDE``, a buffer; ``level:2``, B' of a level; or, of the
            picture that was shown last, ``nnf`` or ``usage``.
        """
        self._worker.do(lambda: self._look(what))

    def export(self, new_folder: Callable[[], Path]) -> None:
        """Write the picture that was shown last, and how it can be made again.

        Parameters
        ----------
        new_folder : callable
            Says where, once there is a picture. The folder is made.
        """
        self._worker.do(lambda: self._worker.say(export(self._worker.shown(), new_folder())))

    def close(self) -> None:
        """End the thread and the process; what is wished for is given up."""
        self._worker.close()

    def _settle(self, settings):
        self._follower.check(settings)
        self._settings = settings
        self._change(lambda: setattr(self._follower, "settings", settings), "cold")

    def _change(self, change: Callable[[], None], wanted: Wanted) -> None:
        """Change the follower; a frame that is made step by step starts again."""

        def change_and_restart():
            change()
            if self._stepper.is_begun:
                self._step("restart")

        self._worker.change(change_and_restart, wanted)

    def _step(self, operation):
        start = perf_counter()
        image = self._stepper.do(operation)
        if image is not None:
            self._worker.show("step", image, start)
        self._worker.say(self._stepper.state)

    def _look(self, what):
        start = perf_counter()
        try:
            picture = picture_of(what, self._follower, self._worker.shown)
        except InputError as error:
            self._worker.say(Problem(str(error), of=what))
        else:
            self._worker.show("look", picture, start, of=what)
