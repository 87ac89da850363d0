"""The painting as the server has it, and what is kept of it on the disk."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.studio.painting.autosave import Autosave
from stylit_ref.studio.painting.folder import PaintingFolder, Saved, Setting

LEAP = 4096
"""From the serial of a painting to that of one which takes its place: more than a page can have
sent before it hears of it."""


class Easel:
    """A painting that grows. It belongs to one thread; saving is done by another.

    Parameters
    ----------
    folder : PaintingFolder
        Is made by the first saving.
    saved : Saved
        What there is at first.
    tell : callable
        Called by the saving thread: see :class:`Autosave`.

    Attributes
    ----------
    folder : PaintingFolder
    painting, beginning : (H, W, 3) uint8
    setting : Setting
    """

    def __init__(
        self, folder: PaintingFolder, saved: Saved, tell: Callable[[InputError | None], None]
    ) -> None:
        self.folder: PaintingFolder = folder
        self.painting: NDArray[np.uint8] = saved.painting.copy()
        self.beginning: NDArray[np.uint8] = saved.beginning
        self.setting: Setting = saved.setting
        self._tell, self._autosave = tell, Autosave(folder, tell)
        self._has_strokes, self._is_unsaved = saved.is_painted, False

    @property
    def size(self) -> tuple[int, int]:
        """Height and width."""
        height, width = self.painting.shape[:2]
        return height, width

    @property
    def serial(self) -> int:
        """Of the last paint."""
        return self.setting.serial

    def paint(self, x: int, y: int, pixels: NDArray[np.uint8], serial: int) -> None:
        """Change a rectangle.

        Parameters
        ----------
        x, y : int
            Its upper left corner.
        pixels : (h, w, 3) uint8
        serial : int
        """
        height, width = pixels.shape[:2]
        self.painting[y : y + height, x : x + width] = pixels
        self.set(replace(self.setting, serial=serial))
        self._has_strokes = True

    def set(self, setting: Setting) -> None:
        """Take another setting, to be saved with the painting."""
        self.setting, self._is_unsaved = setting, True

    def replace(self, painting: NDArray[np.uint8]) -> Path | None:
        """Take a painting that was made elsewhere; its serial is :data:`LEAP` further.

        Parameters
        ----------
        painting : (H, W, 3) uint8

        Returns
        -------
        Path or None
            Where the one before it is kept, if anybody has painted on it here.

        Raises
        ------
        InputError
            If that cannot be written; the painting is then as it was.
        """
        kept = self.folder.keep(self.painting) if self._has_strokes else None
        self.painting, self._has_strokes = painting.copy(), False
        self.set(replace(self.setting, serial=self.serial + LEAP))
        return kept

    def save(self) -> None:
        """Have it saved soon."""
        if self._is_unsaved:
            self._is_unsaved = False
            self._autosave.save(Saved(self.painting.copy(), self.beginning, self.setting))

    def close(self) -> None:
        """Return when all is saved.

        Raises
        ------
        InputError
            If it cannot be saved; the easel then goes on.
        """
        self.save()
        try:
            self._autosave.close()
        except InputError:
            self._autosave, self._is_unsaved = Autosave(self.folder, self._tell), True
            raise
