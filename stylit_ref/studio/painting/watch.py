"""A painting that another program saves: read whenever it has changed and is whole."""

import logging
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from threading import Event, Thread

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.studio.painting.paint_file import read_paint
from stylit_ref.studio.painting.whole_png import is_damaged_png

LOGGER: logging.Logger = logging.getLogger(__name__)

PAUSE = 0.2
"""Seconds between two looks. What is on a network is seen so, too."""

PATIENCE = 10
"""Looks at a file that stays as it is and cannot be read, before that is told."""


class Watch:
    """What is known of a watched file; :meth:`look` is called again and again.

    A program may write in place, so a file is read when two looks have found it the same, and one
    that cannot be read is taken for half-written until it has stayed so for a while.

    Parameters
    ----------
    file : str or Path
        What it holds now is known.
    size : tuple of int
        Height and width that it must have.
    """

    def __init__(self, file: str | Path, size: tuple[int, int]) -> None:
        self.file: Path = Path(file)
        self._size = size
        self._last = self._done = self._signature()
        self._failures = 0

    def look(self) -> NDArray[np.uint8] | None:
        """The painting if there is a new one.

        Returns
        -------
        (H, W, 3) uint8 or None

        Raises
        ------
        InputError
            Once for each state of the file that is of no use: of another size, or damaged.
        """
        signature = self._signature()
        if signature is None or signature == self._done:
            return None
        if signature != self._last:
            self._last, self._failures = signature, 0
            return None
        try:
            painting = self._read()
        except InputError:
            self._failures += 1
            if self._failures < PATIENCE:
                return None
            self._done = signature
            raise
        except Exception:
            self._done = signature
            raise
        if self._signature() != signature:  # it was being written meanwhile
            return None
        self._done = signature
        if painting.shape[:2] != self._size:
            raise InputError(self._why_refused(painting.shape[:2]))
        return painting

    def _read(self):
        with suppress(OSError):  # what it means that it cannot be read is told by who reads it
            if is_damaged_png(self.file):
                raise InputError(f"{self.file}: is a damaged PNG; save it again")
        return read_paint(self.file)

    def _why_refused(self, found):
        (height, width), (old_height, old_width) = found, self._size
        same_aspect = height * old_width == width * old_height
        how = "size" if same_aspect else "size and aspect"
        return (
            f"{self.file}: has become {width}x{height}, another {how} than {old_width}x"
            f"{old_height}, so the painting before it stays; save it as {old_width}x{old_height}"
        )

    def _signature(self):
        try:
            state = self.file.stat()
        except OSError:  # a program may take the old file away before it writes the new one
            return None
        return state.st_mtime_ns, state.st_size, state.st_ino


class Watcher:
    """Looks at a file in a thread of its own.

    Parameters
    ----------
    watch : Watch
    tell : callable
        Called by the thread with a painting, or with why there is none.
    pause : float
        Seconds between two looks.
    """

    def __init__(
        self,
        watch: Watch,
        tell: Callable[[NDArray[np.uint8] | InputError], None],
        *,
        pause: float = PAUSE,
    ) -> None:
        self._watch, self._tell, self._pause = watch, tell, pause
        self._ends = Event()
        self._thread = Thread(target=self._run, name="watch", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Look no more."""
        self._ends.set()
        self._thread.join()

    def _run(self):
        while not self._ends.wait(self._pause):
            try:
                painting = self._watch.look()
            except InputError as error:
                self._tell(error)
            except Exception:
                LOGGER.exception("the watched file cannot be looked at; please report it")
                self._tell(InputError("the watched file failed; the terminal says how"))
            else:
                if painting is not None:
                    self._tell(painting)
