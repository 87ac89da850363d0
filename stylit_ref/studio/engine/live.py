"""The picture that follows: one thread that computes, and a process in the background."""

import logging
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from threading import Condition, Thread
from time import perf_counter
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.parameters import Integer
from stylit_ref.realtime.session import FrameCancelledError
from stylit_ref.studio.engine.background import Background, Wish
from stylit_ref.studio.engine.events import Compiling, Event, Picture, Problem
from stylit_ref.studio.engine.export import export
from stylit_ref.studio.engine.follower import Follower
from stylit_ref.studio.engine.looking import picture_of
from stylit_ref.studio.engine.painting import check_painting, check_rectangle
from stylit_ref.studio.engine.parameters import Settings
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.engine.shown import Shown
from stylit_ref.studio.engine.stepping import OPERATIONS, Stepper

_COMPILING = "kernels of the live picture"
_PATIENCE = 2.0  # seconds: a kernel that is being compiled cannot be interrupted


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
        self._tell = tell
        self._scene, self._settings = scene, Settings(seed=seed)  # as they will be
        self._changed = Condition()
        self._changes: deque[Callable[[], None]] = deque()  # of the follower, in their order
        self._tasks: deque[Callable[[], None]] = deque()  # to be done when the picture is there
        self._wants_replay = False
        self._wanted: Literal["warm", "cold"] | None = "cold"  # the next frame
        self._is_searching = False
        self._is_closed = False
        self._made: Shown | None = None  # in the background, of all as it is
        self._follower = Follower(scene, painting, self._settings, threads)
        self._stepper = Stepper(self._follower.own_session)
        self._background = Background(self._say, self._keep)
        self._thread = Thread(target=self._work, name="studio", daemon=True)
        self._thread.start()

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
        self._change(lambda: self._follower.paint(x, y, pixels, serial), is_stroke=True)

    def rest(self, serial: int) -> None:
        """The brush pauses: a coherent frame follows, then ``fast`` in the background."""
        with self._changed:
            self._wanted = self._wanted or "cold"
            self._changed.notify()

    def replace_painting(self, painting: NDArray[np.uint8], serial: int) -> None:
        """Take another painting; the rest is as after a pause of the brush.

        Raises
        ------
        InputError
            If it does not fit the scene.
        """
        painting = check_painting(painting, self._scene).copy()
        self._change(lambda: self._follower.replace_painting(painting, serial), "cold")

    def finish(self) -> None:
        """Begin the full method in the background."""
        self._do(lambda: self._background.begin(self._wish("full")))

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
        elif scene.size != self._scene.size:
            raise InputError(
                f"{scene.title} is painted at {scene.size[1]}x{scene.size[0]} pixels, and the "
                f"painting has {self._scene.size[1]}x{self._scene.size[0]}; begin another painting"
            )
        self._scene = scene
        if painting is not None:
            self._change(lambda: self._follower.replace_painting(painting, serial))
        self._take("cold", scene=scene, step=0)

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
        self._take(("warm" if warm else "cold") if restylize else None, step=step)

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
        self._do(lambda: self._step(operation))

    def look(self, what: str) -> None:
        """Ask for a picture to look at.

        Parameters
        ----------
        what : str
            ``style``; ``A:LDE`` or ``B:LDE``, a buffer; ``level:2``, B' of a level; or, of the
            picture that was shown last, ``nnf`` or ``usage``.
        """
        self._do(lambda: self._look(what))

    def export(self, folder: Path) -> None:
        """Write the picture that was shown last, and how it can be made again.

        Parameters
        ----------
        folder : Path
        """
        self._do(lambda: self._say(export(self._shown(), folder)))

    def close(self) -> None:
        """End the thread and the process; what is wished for is given up."""
        with self._changed:
            self._is_closed = True
            self._follower.cancel()
            self._changed.notify()
        self._background.close()
        self._thread.join(_PATIENCE)

    def _settle(self, settings):
        self._settings = settings
        self._take("cold", settings=settings)

    def _change(self, change, wanted=None, *, is_stroke=False):
        self._background.cancel()
        self._made = None
        with self._changed:
            self._changes.append(change)
            can_replay = self._follower.can_replay
            if is_stroke:
                self._wants_replay = True
                if can_replay:  # a frame waits until the brush rests
                    self._wanted = None
            else:
                self._wanted = wanted
            # The first frame is not ended by strokes: without it there is no picture at all.
            if self._is_searching and (can_replay or not is_stroke):
                self._follower.cancel()
            self._changed.notify()

    def _take(self, wanted, **attributes):
        """Change attributes of the follower; a frame that is made step by step starts again."""

        def take():
            for name, value in attributes.items():
                setattr(self._follower, name, value)
            self._stepper.do("restart")

        self._change(take, wanted)

    def _do(self, task):
        with self._changed:
            self._tasks.append(task)
            self._changed.notify()

    def _work(self):
        """What the thread does: changes first, then a frame, and whatever else at last."""
        while self._await_work():
            try:
                self._follow()
            except FrameCancelledError:
                continue
            except InputError as error:
                self._say(Problem(str(error)))
            except Exception:
                logging.getLogger(__name__).exception("the studio's engine failed")
                self._say(Problem("something went wrong; the terminal says what"))

    def _await_work(self):
        with self._changed:
            self._changed.wait_for(
                lambda: self._is_closed or self._changes or self._wanted or self._tasks
            )
            return not self._is_closed

    def _follow(self):
        start = perf_counter()
        with self._changed:
            changes, wants_replay = list(self._changes), self._wants_replay
            self._changes.clear()
            self._wants_replay = False
        for change in changes:
            change()
        if wants_replay and self._follower.can_replay:
            self._prepare()
            self._show("replay", self._follower.replay(), start)
        with self._changed:
            if self._changes:
                return
            wanted, self._wanted = self._wanted, None
        if wanted:
            self._frame(wanted == "warm")
        elif self._tasks:
            self._tasks.popleft()()

    def _frame(self, warm):
        start = perf_counter()
        self._prepare()
        if not self._follower.is_searched:
            with self._changed:
                if self._changes:  # meanwhile
                    self._wanted = self._wanted or ("warm" if warm else "cold")
                    return
                self._is_searching = True
            try:
                which, image = self._follower.frame(warm=warm)
            finally:
                self._is_searching = False
            self._show(which, image, start)
        if self._made is None and not self._background.is_busy:
            self._background.begin(self._wish("fast"))

    def _prepare(self):
        compiled = 0

        def compiling(number, total):
            nonlocal compiled
            compiled = total
            self._say(Compiling(_COMPILING, number - 1, total))

        self._follower.prepare(compiling)
        if compiled:
            self._say(Compiling(_COMPILING, compiled, compiled))

    def _step(self, operation):
        start = perf_counter()
        image = self._stepper.do(operation)
        if image is not None:
            self._show("step", image, start)
        self._say(self._stepper.state)

    def _look(self, what):
        start = perf_counter()
        self._show("look", picture_of(what, self._follower, self._shown), start)

    def _shown(self):
        return self._made or self._follower.shown()

    def _wish(self, which):
        follower = self._follower
        return Wish(
            which, follower.painting.copy(), follower.scene, follower.step, follower.settings,
            follower.serial,
        )  # fmt: skip

    def _show(self, which, image, start):
        milliseconds = 1000 * (perf_counter() - start)
        self._say(Picture(which, image, self._follower.serial, milliseconds))

    def _say(self, event):
        if not self._is_closed:
            self._tell(event)

    def _keep(self, shown):
        self._made = shown
