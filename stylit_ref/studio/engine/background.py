"""Pictures of the dense method, made by a process of low priority beside the page."""

import ctypes
import logging
import multiprocessing
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from threading import Condition, Thread
from time import monotonic
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.field import Field
from stylit_ref.machine.memory import return_free_memory
from stylit_ref.realtime.packing import Packing
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.studio.engine.dense_work import (
    Ahead,
    Failed,
    Going,
    Job,
    Kernels,
    Made,
    Stopped,
    work,
)
from stylit_ref.studio.engine.events import Compiling, Event, Picture, Working
from stylit_ref.studio.engine.parameters import Settings
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.engine.shown import Shown

_PATIENCE = 5.0
"""Seconds until an unwanted search is killed that does not stop: to begin anew takes less."""

_COMPILING = "kernels of the finer picture"
_LOOKS = 0.5  # seconds between two looks whether one has lasted so long


@dataclass(frozen=True, eq=False)
class Wish:
    """A picture of the dense method.

    Attributes
    ----------
    which : {"fast", "full"}
    style : (H_A, W_A, 3) uint8
        A copy, which nobody changes.
    scene : Scene
    step : int
    settings : Settings
    serial : int
        Of the style.
    """

    which: Literal["fast", "full"]
    style: NDArray[np.uint8]
    scene: Scene
    step: int
    settings: Settings
    serial: int


class _Answered(NamedTuple):
    """A picture that was made, and how long it took in milliseconds."""

    shown: Shown
    milliseconds: float


class Background:
    """Makes the picture that was wished last; an earlier wish is given up.

    The process lives on between wishes. If it ends without being told to, it is begun anew.

    Parameters
    ----------
    tell : callable
        Called with events, from a thread of its own.
    made : callable
        Called with what was made, before its picture is told.
    """

    def __init__(self, tell: Callable[[Event], None], made: Callable[[Shown], None]) -> None:
        self._tell, self._made = tell, made
        self._context = multiprocessing.get_context("spawn")
        self._wanted = self._context.RawValue(ctypes.c_uint64, 0)
        self._changed = Condition()
        self._ahead: Ahead | None = None
        self._wish: Wish | None = None
        self._working_on: int | None = None
        self._is_closed = False
        self._process: BaseProcess | None = None
        self._connection: Connection | None = None
        self._sent: tuple[Scene, int] | None = None  # whose guides the process has
        self._thread = Thread(target=self._serve, name="studio background", daemon=True)
        self._thread.start()

    @property
    def process_id(self) -> int | None:
        """Of the process; None before the first."""
        return self._process.pid if self._process else None

    @property
    def is_busy(self) -> bool:
        """Whether a picture that is wanted is being made, or is to be made."""
        with self._changed:
            return self._wish is not None or self._is_wanted(self._working_on)

    def begin(self, wish: Wish) -> None:
        """Make this picture, and no other."""
        self._want(wish)

    def compile_ahead(self, params: RealtimeParams, packing: Packing) -> None:
        """Compile kernels of live frames before the next picture, those that come last first."""
        with self._changed:
            self._ahead = Ahead(params, packing)
            self._changed.notify()

    def cancel(self) -> None:
        """Make no picture."""
        self._want(None)

    def close(self) -> None:
        """End the process and the thread."""
        with self._changed:
            self._is_closed = True
        self.cancel()
        if self._process:
            self._process.kill()
        self._thread.join()

    def _want(self, wish):
        with self._changed:
            self._wish = wish
            self._wanted.value += 1
            self._changed.notify()

    def _serve(self):
        self._tried(Stopped)  # to begin the process takes a second or two, so before it is needed
        while self._await_wish():
            if self._ahead:
                message, self._ahead = self._ahead, None
                self._tried(partial(self._answered, message))
                continue
            with self._changed:
                wish, number, self._wish = self._wish, self._wanted.value, None
                self._working_on = number
            if wish:
                self._fulfil(wish, number)
            self._working_on = None
        self._end()

    def _await_wish(self):
        with self._changed:
            self._changed.wait_for(lambda: self._ahead or self._wish or self._is_closed)
            return not self._is_closed

    def _fulfil(self, wish, number):
        self._tell(Working(wish.which, "started", ""))
        answer = self._tried(partial(self._answer, wish, number))
        if answer is None and self._is_wanted(number):
            answer = self._tried(partial(self._answer, wish, number)) or Failed(
                "the process in the background ended twice; try again"
            )
        if isinstance(answer, _Answered):  # so the painter pauses
            return_free_memory()
        self._report(wish, number, answer or Stopped())

    def _tried(self, ask):
        """What the process answers, which is begun if there is none; None if it has ended."""
        try:
            if self._connection is None:
                self._start()
            return ask()
        except InputError as error:
            return Failed(str(error))
        except (EOFError, OSError):
            self._end()
            return None
        except Exception:
            logging.getLogger(__name__).exception("the studio's background failed")
            self._end()
            return Failed("something went wrong; the terminal says what")

    def _report(self, wish, number, answer):
        match answer:
            case _Answered(shown, milliseconds):
                with self._changed:
                    is_wanted = self._is_wanted(number)
                    if is_wanted:
                        self._made(shown)
                if is_wanted:
                    self._tell(Picture(wish.which, shown.image, wish.serial, milliseconds))
                self._tell(Working(wish.which, "done" if is_wanted else "cancelled", ""))
            case Failed(text):
                self._tell(Working(wish.which, "failed", text))
            case Stopped():
                self._tell(Working(wish.which, "cancelled", ""))

    def _answer(self, wish, number):
        """Send the wish to the process, and hear what it says until that is an answer."""
        connection = self._connection
        guides = None
        if self._sent != (wish.scene, wish.step):
            target = wish.scene.target(wish.step)
            guides = list(wish.scene.source.values()), list(target.values())
        params = wish.settings.dense_params(wish.which, wish.scene.buffers)
        connection.send(Job(number, wish.style, guides, params, wish.settings.seed))
        self._sent = wish.scene, wish.step
        kernels = 0
        while True:
            self._await(number, is_compiling=kernels > 0)
            message = connection.recv()
            if isinstance(message, Kernels):
                kernels = message.total
                self._tell(Compiling(_COMPILING, message.number - 1, kernels))
                continue
            if kernels:
                self._tell(Compiling(_COMPILING, kernels, kernels))
                kernels = 0
            if isinstance(message, Made):
                shown = _shown(wish, message.image, message.nnf)
                return _Answered(shown, message.milliseconds)
            if not isinstance(message, Going):
                return message
            self._tell(Working(wish.which, "started", f"{message.done:.0%}"))

    def _answered(self, message):
        self._connection.send(message)
        return self._connection.recv()

    def _await(self, number, is_compiling):
        """Wait for a message; kill a search that is unwanted and does not stop."""
        unwanted_since = None
        while not self._connection.poll(_LOOKS):
            if self._is_wanted(number) or is_compiling:
                continue
            unwanted_since = unwanted_since or monotonic()
            if monotonic() - unwanted_since > _PATIENCE:
                self._process.kill()

    def _is_wanted(self, number):
        return self._wanted.value == number

    def _start(self):
        own, other = self._context.Pipe()
        process = self._context.Process(
            target=work, args=(other, self._wanted), name="studio background", daemon=True
        )
        process.start()
        self._process, self._connection = process, own  # before it starts it cannot be killed
        other.close()  # so that the end of the process is noticed
        self._sent = None

    def _end(self):
        if self._process:
            self._process.kill()
            self._process.join()
        if self._connection:
            with suppress(OSError):
                self._connection.close()
        self._connection = None


def _shown(wish: Wish, image: NDArray[np.uint8], nnf: NDArray[np.int32]) -> Shown:
    field = Field(
        nnf,
        wish.settings.dense_params(wish.which, wish.scene.buffers).patch_width,
        style_size=wish.scene.size,
        guide_encodings=wish.scene.encodings,
    )
    return Shown(
        wish.which, image, wish.style, field, wish.scene, wish.step, wish.settings
    )  # fmt: skip
