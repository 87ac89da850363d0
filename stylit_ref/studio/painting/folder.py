"""A folder that holds a painting and what it was painted with; a restart begins with it."""

import json
import logging
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import check_folder
from stylit_ref.files.disk.whole_file import write_text
from stylit_ref.notes import note
from stylit_ref.studio.painting.paint_file import read_paint, write_paint

_VERSION = 1

LARGEST_SERIAL = 2**32 - 1
"""The largest number of a paint: page and server tell it in four bytes."""


@dataclass(frozen=True)
class Setting:
    """All but the painting.

    Attributes
    ----------
    scene : str
    step : int
        Of its turntable.
    seed : int
    serial : int
        Of the last paint.
    parameters, weights : mapping of str
    layers : mapping of str to list of str
        By scene, those that are picked.
    """

    scene: str = ""
    step: int = 0
    seed: int = 0
    serial: int = 0
    parameters: Mapping[str, Any] = field(default_factory=dict)
    weights: Mapping[str, int] = field(default_factory=dict)
    layers: Mapping[str, list[str]] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Saved:
    """What a folder holds.

    Attributes
    ----------
    painting : (H, W, 3) uint8
    beginning : (H, W, 3) uint8
        What it began with, which an eraser brings back.
    setting : Setting
    is_painted : bool
        Whether anybody has painted on it here: if another one takes its place, it is kept.
    """

    painting: NDArray[np.uint8]
    beginning: NDArray[np.uint8]
    setting: Setting
    is_painted: bool = False


class PaintingFolder:
    """A named folder; what is written there appears whole or not at all.

    Parameters
    ----------
    folder : str or Path
        Need not exist yet.
    within : PaintingFolder, optional
        One that keeps the setting of this one, too.

    Attributes
    ----------
    folder : Path
    root : Path
        The folder that keeps the setting: this one, or the one that it is within.

    Raises
    ------
    InputError
        If it can neither be written nor made.
    """

    def __init__(self, folder: str | Path, within: "PaintingFolder | None" = None) -> None:
        check_folder(folder)
        self.folder: Path = Path(folder)
        self.root: Path = within.root if within else self.folder

    @property
    def style(self) -> Path:
        """The painting's file."""
        return self.folder / "style.png"

    def of_size(self, size: tuple[int, int]) -> "PaintingFolder":
        """A folder within this one, for a painting of another height and width."""
        height, width = size
        return PaintingFolder(self.folder / f"{width}x{height}", self)

    def new_export(self) -> Path:
        """The next folder for exported files by its number, to be made by whoever writes them."""
        return self._exports / f"{self._last_export + 1:03d}"

    def exported(self) -> Path:
        """The folder of the last export, which need not be there."""
        return self._exports / f"{self._last_export:03d}"

    @property
    def _exports(self) -> Path:
        return self.folder / "exports"

    @property
    def _last_export(self) -> int:
        if not self._exports.is_dir():
            return 0
        names = (each.name for each in self._exports.iterdir() if each.is_dir())
        return max((int(name) for name in names if name.isdecimal()), default=0)

    @property
    def _setting(self) -> Path:
        return self.root / "studio.json"

    @property
    def _beginning(self) -> Path:
        return self.folder / "beginning.png"

    def load(self, size: tuple[int, int]) -> Saved | None:
        """What was saved; None in a folder without a painting.

        Parameters
        ----------
        size : tuple of int
            Height and width that the painting must have.

        Raises
        ------
        InputError
            If the painting cannot be read, or has another size.
        """
        if not self.style.is_file():
            return None
        try:
            painting = read_paint(self.style, size)
        except InputError as error:
            raise InputError(f"{error}, or name another folder by --painting") from None
        beginning, is_painted = painting, True
        with suppress(InputError):  # else the eraser brings back what is there now
            beginning = read_paint(self._beginning, size)
            is_painted = not np.array_equal(painting, beginning)
        return Saved(painting, beginning, self.setting(), is_painted)

    def save(self, saved: Saved) -> None:
        """Write the painting, then its setting, whose serial is never ahead of the paint.

        Raises
        ------
        InputError
            If they cannot be written.
        """
        if not self._beginning.exists():
            write_paint(self._beginning, saved.beginning)
        write_paint(self.style, saved.painting)
        facts = {"version": _VERSION, **vars(saved.setting)}
        write_text(self._setting, json.dumps(facts, indent=2) + "\n")

    def keep(self, painting: NDArray[np.uint8]) -> Path:
        """Save a painting that another one replaces, under a new name.

        Parameters
        ----------
        painting : (H, W, 3) uint8

        Returns
        -------
        Path
            The file.

        Raises
        ------
        InputError
            If it cannot be written.
        """
        number = 1
        while (file := self.folder / "replaced" / f"style_{number:03d}.png").exists():
            number += 1
        write_paint(file, painting)
        return file

    @property
    def saved_when(self) -> str:
        """When the painting was saved, for people."""
        then = datetime.fromtimestamp(self.style.stat().st_mtime)
        return f"on {then:%Y-%m-%d} at {then:%H:%M}"

    def setting(self) -> Setting:
        """The setting, or the usual one if there is none of this version; a note says so."""
        if not self._setting.is_file():
            return Setting()
        try:
            facts = json.loads(self._setting.read_text(encoding="utf-8"))
            if not (isinstance(facts, dict) and facts.pop("version", None) == _VERSION):
                raise ValueError
            setting = Setting(**facts)
            is_known = all(isinstance(vars(setting)[name], kind) for name, kind in _KINDS.items())
            if not (is_known and setting.step >= 0 and 0 <= setting.serial <= LARGEST_SERIAL):
                raise ValueError
        except (OSError, ValueError, TypeError, RecursionError):
            note(
                f"{self._setting}: cannot be read, so sliders, scene and seed are the usual ones",
                level=logging.WARNING,
            )
            return Setting()
        return setting


_KINDS = {
    "scene": str, "step": int, "seed": int, "serial": int, "parameters": dict, "weights": dict,
    "layers": dict,
}  # fmt: skip
