"""The thread of the studio: it lets a follower follow, and whatever else there is to do."""

import logging
from collections import deque
from collections.abc import Callable
from functools import partial
from threading import Condition, Thread
from time import perf_counter
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.realtime.session import FrameCancelledError
from stylit_ref.studio.engine.background import Background, Wish
from stylit_ref.studio.engine.events import Compiling, Event, Picture, Problem, Which
from stylit_ref.studio.engine.follower import Follower
from stylit_ref.studio.engine.shown import Shown
from stylit_ref.studio.engine.strokes import Strokes

_COMPILING = "kernels of the live picture"
_PATIENCE = 2.0  # seconds: a kernel that is being compiled cannot be interrupted

Wanted = Literal["warm", "cold"] | None
"""The next frame, if one is wanted."""


class Worker:
    """One thread that changes a follower, makes its frames, and does tasks when these are there.

    Other threads say what they want, and that at once: changes keep their order, and of frames the
    newest wins. After a frame, ``fast`` begins in the background; a change gives it up.

    Parameters
    ----------
    follower : Follower
        Belongs to the thread.
    tell : callable
        Called with every event.
    """

    def __init__(self, follower: Follower, tell: Callable[[Event], None]) -> None:
        self._follower, self._tell = follower, tell
        self._changed = Condition()
        self._changes: deque[Callable[[], None]] = deque()
        self._waiting: Strokes | None = None  # the last of the changes, if it is paint
        self._tasks: deque[Callable[[], None]] = deque()
        self._wants_replay = False
        self._wanted: Wanted = "cold"
        self._is_searching = False
        self._is_closed = False
        self._made: Shown | None = None  # in the background, of all as it is
        self._background = Background(self.say, self._keep)
        self._thread = Thread(target=self._work, name="studio", daemon=True)
        self._thread.start()

    def stroke(
        self, x: int, y: int, pixels: NDArray[np.uint8], serial: int, painting: NDArray[np.uint8]
    ) -> None:
        """Change the painting; a replay follows, and a frame when the brush rests.

        Parameters are those of :meth:`Strokes.add`.
        """
        with self._changed:
            self._give_up()
            if self._waiting is None:
                self._waiting = Strokes()
                self._changes.append(partial(self._waiting.onto, self._follower))
            self._waiting.add(x, y, pixels, serial, painting)
            self._wants_replay = True
            # The first frame is not ended: without it there is no picture at all.
            if self._follower.can_replay:
                self._wanted = None
                if self._is_searching:
                    self._follower.cancel()
            self._changed.notify()

    def change(self, change: Callable[[], None], wanted: Wanted) -> None:
        """Change something else; a frame follows at once, or when one is wanted."""
        with self._changed:
            self._give_up()
            self._waiting = None
            self._changes.append(change)
            self._wanted = wanted
            if self._is_searching:
                self._follower.cancel()
            self._changed.notify()

    def want_frame(self) -> None:
        """Have a frame of all as it is."""
        with self._changed:
            self._wanted = self._wanted or "cold"
            self._changed.notify()

    def do(self, task: Callable[[], None]) -> None:
        """Do something when the picture is there."""
        with self._changed:
            self._tasks.append(task)
            self._changed.notify()

    def close(self) -> None:
        """End the thread and the process in the background; nothing is told any more."""
        with self._changed:
            self._is_closed = True
            self._follower.cancel()
            self._changed.notify()
        self._background.close()
        self._thread.join(_PATIENCE)

    # For tasks and changes, which run in the thread.

    def say(self, event: Event) -> None:
        """Tell an event."""
        if not self._is_closed:
            self._tell(event)

    def show(self, which: Which, image: NDArray[np.uint8], start: float, of: str = "") -> None:
        """Tell a picture that was begun at ``start``, in seconds of ``perf_counter``."""
        milliseconds = 1000 * (perf_counter() - start)
        self.say(Picture(which, image, self._follower.serial, milliseconds, of))

    def begin(self, which: Literal["fast", "full"]) -> None:
        """Begin a picture in the background, unless it would be out of date already."""
        follower = self._follower
        wish = Wish(
            which, follower.painting.copy(), follower.scene, follower.step, follower.settings,
            follower.serial,
        )  # fmt: skip
        with self._changed:
            if not self._changes:
                self._background.begin(wish)

    def shown(self) -> Shown:
        """The picture that was shown last, steps and looks apart.

        Raises
        ------
        InputError
            If there is none.
        """
        return self._made or self._follower.shown()

    def _give_up(self):
        self._background.cancel()
        self._made = None

    def _keep(self, shown):
        self._made = shown

    def _work(self):
        """What the thread does: changes first, then a frame, and whatever else at last."""
        while self._await_work():
            try:
                self._follow()
            except FrameCancelledError:
                continue
            except InputError as error:
                self.say(Problem(str(error)))
            except MemoryError:
                self.say(Problem("there is not enough memory for a picture of this size"))
            except Exception:
                logging.getLogger(__name__).exception("the studio's engine failed")
                self.say(Problem("something went wrong; the terminal says what"))

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
            self._waiting = None
            self._wants_replay = False
        for change in changes:
            change()
        if wants_replay and self._follower.can_replay:
            self._prepare()
            self.show("replay", self._follower.replay(), start)
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
        if self._prepare():
            start = perf_counter()
        if not self._follower.is_searched:
            with self._changed:
                if self._changes:  # meanwhile; after a stroke the brush will rest again
                    if not self._follower.can_replay:
                        self._wanted = self._wanted or ("warm" if warm else "cold")
                    return
                self._is_searching = True
            try:
                which, image = self._follower.frame(warm=warm)
            finally:
                self._is_searching = False
            self.show(which, image, start)
        if self._made is None and not self._background.is_busy:
            self.begin("fast")

    def _prepare(self):
        """Whether kernels were compiled, which is nothing that a picture takes."""
        compiled = 0

        def compiling(number, total):
            nonlocal compiled
            compiled = total
            self.say(Compiling(_COMPILING, number - 1, total))

        self._follower.prepare(compiling, self._background.compile_ahead)
        if compiled:
            self.say(Compiling(_COMPILING, compiled, compiled))
        return compiled > 0
