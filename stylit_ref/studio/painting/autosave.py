"""Save a painting in a thread of its own, the newest state, and not too often."""

import logging
import time
from collections.abc import Callable
from threading import Condition, Thread

from stylit_ref.errors import InputError
from stylit_ref.studio.painting.folder import PaintingFolder, Saved

LOGGER: logging.Logger = logging.getLogger(__name__)

PAUSE = 1.0
"""Seconds between two savings."""


class Autosave:
    """Saves what it is given, unless something newer comes first.

    Parameters
    ----------
    folder : PaintingFolder
    tell : callable
        Called by the thread with an error, or with None when all is on the disk.
    pause : float
        Seconds between two savings.
    """

    def __init__(
        self,
        folder: PaintingFolder,
        tell: Callable[[InputError | None], None],
        *,
        pause: float = PAUSE,
    ) -> None:
        self._folder, self._tell, self._pause = folder, tell, pause
        self._newest: Saved | None = None
        self._failure: tuple[Saved, InputError] | None = None  # of the last saving
        self._ends, self._changed = False, Condition()
        self._thread = Thread(target=self._run, name="autosave", daemon=True)
        self._thread.start()

    def save(self, saved: Saved) -> None:
        """Have this saved soon; its painting must not change any more."""
        with self._changed:
            self._newest = saved
            self._changed.notify()

    def close(self) -> None:
        """Return when all is saved; what could not be saved before is tried once more.

        Raises
        ------
        InputError
            If it cannot be saved.
        """
        with self._changed:
            self._ends = True
            self._changed.notify()
        self._thread.join()
        if self._failure:
            raise self._failure[1]

    def _run(self):
        next_time, ends = 0.0, False
        while not ends:
            with self._changed:
                self._changed.wait_for(lambda: self._newest is not None or self._ends)
                self._changed.wait_for(lambda: self._ends, next_time - time.monotonic())
                saved, self._newest, ends = self._newest, None, self._ends
            if saved is None and self._failure:
                saved = self._failure[0]
            if saved is None:
                return
            next_time = time.monotonic() + self._pause
            try:
                self._folder.save(saved)
            except InputError as error:
                self._failure = saved, error
            except Exception:
                LOGGER.exception("the painting cannot be saved; please report it")
                self._failure = saved, InputError("something went wrong; the terminal says what")
            else:
                self._failure = None
            self._tell(self._failure and self._failure[1])
