"""What a studio begins with: what was saved, or a painting to begin with."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.painting.folder import PaintingFolder, Saved, Setting
from stylit_ref.studio.painting.paint_file import read_paint
from stylit_ref.studio.scene_files.shelf import Shelf


@dataclass(frozen=True, eq=False)
class Beginning:
    """What a studio begins with.

    Attributes
    ----------
    shelf : Shelf
    folder : PaintingFolder
    saved : Saved
    scene : Scene
        That of the setting, opened.
    notes : sequence of str
        What is told of it.
    """

    shelf: Shelf
    folder: PaintingFolder
    saved: Saved
    scene: Scene
    notes: Sequence[str]


def begin(
    shelf: Shelf,
    folder: PaintingFolder,
    *,
    style: str | Path | None = None,
    watched: str | Path | None = None,
) -> Beginning:
    """Read what there is in the folder, or begin with a style or with the source's render.

    Parameters
    ----------
    shelf : Shelf
    folder : PaintingFolder
    style : str or Path, optional
        To begin a new painting with.
    watched : str or Path, optional
        A file that another program paints: it counts more than what was saved, which is kept.

    Raises
    ------
    InputError
        If a file cannot be read or has another size, or ``style`` would replace a painting.
    """
    notes: list[str] = []
    saved = folder.load(shelf.size)
    if saved is None:
        painting = _first_painting(shelf, style)
        saved = Saved(painting, painting, Setting())
    elif style is not None:
        raise InputError(
            f"is to begin with, but {folder.folder} holds a painting; leave it out, or name "
            "another folder by --painting",
            parameter="style",
        )
    else:
        notes.append(f"The painting in {folder.folder} is back; it was saved {folder.saved_when}.")
    if watched is not None and Path(watched).exists():
        painting = read_paint(watched, shelf.size)
        if notes and not np.array_equal(painting, saved.painting):
            kept = folder.keep(saved.painting)
            notes = [f"The painting is that of {watched}; the one before it is kept as {kept}."]
        setting = replace(saved.setting, serial=saved.setting.serial + 1)
        saved = Saved(painting, saved.beginning, setting)
    scene, setting = _opened(shelf, saved.setting, notes)
    return Beginning(shelf, folder, replace(saved, setting=setting), scene, notes)


def _first_painting(shelf: Shelf, style: str | Path | None) -> NDArray[np.uint8]:
    if style is not None:
        return read_paint(style, shelf.size)
    return shelf.first.rendering()


def _opened(shelf: Shelf, setting: Setting, notes: list[str]) -> tuple[Scene, Setting]:
    """The scene that was open, or the first if that is not there any more."""
    name = setting.scene or shelf.first.name
    try:
        scene = shelf.open(name, setting.layers.get(name, ()))
    except InputError as error:
        if not setting.scene:
            raise
        notes.append(f"The scene {name} of last time is not here: {error}.")
        name = shelf.first.name
        return shelf.open(name), replace(setting, scene=name, step=0)
    step = setting.step if setting.step < scene.steps else 0
    return scene, replace(setting, scene=name, step=step)
