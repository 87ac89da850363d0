"""What a studio begins with: what was saved, or a painting to begin with."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import check_writable
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.painting.folder import PaintingFolder, Saved, Setting
from stylit_ref.studio.painting.paint_file import read_paint, write_paint
from stylit_ref.studio.painting.watch import Watch
from stylit_ref.studio.scene_files.offer import Offer
from stylit_ref.studio.scene_files.shelf import Shelf
from stylit_ref.studio.server.protocol import sentence


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
    watch : Watch or None
        Of a file that another program paints.
    """

    shelf: Shelf
    folder: PaintingFolder
    saved: Saved
    scene: Scene
    notes: Sequence[str]
    watch: Watch | None = None


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
        A file that another program paints: it counts more than what was saved, which is kept. If
        there is none, it is written.

    Raises
    ------
    InputError
        If a file cannot be read or written, or has another size, or ``style`` would replace a
        painting.
    """
    notes: list[str] = []
    offer = _last_offer(shelf, folder.setting().scene, notes)
    place = folder_of(offer, shelf, folder)
    saved = place.load(offer.size)
    if saved is None:
        painting = offer.rendering() if style is None else read_paint(style, offer.size)
        saved = Saved(painting, painting, folder.setting())
    elif style is not None:
        raise InputError(
            f"is to begin with, but {place.folder} holds a painting; leave it out, or name "
            "another folder by --painting",
            parameter="style",
        )
    else:
        notes.append(f"The painting in {place.folder} is back; it was saved {place.saved_when}.")
    watch = None
    if watched is not None and Path(watched).exists():
        watch = Watch(watched, offer.size)  # before it is read: what is saved later is new
        painting = read_paint(watched, offer.size)
        before = saved.painting
        setting = replace(saved.setting, serial=saved.setting.serial + 1)
        saved = Saved(painting, saved.beginning, setting)
        if place.style.exists() and not np.array_equal(painting, before):
            kept = place.keep(before)
            place.save(saved)
            text = f"The painting is that of {watched}; the one before it is kept as {kept}."
            notes[-1] = text
    scene = _opened(offer, saved.setting, notes)
    step = saved.setting.step if saved.setting.scene == offer.name else 0
    setting = replace(saved.setting, scene=offer.name, step=step if step < scene.steps else 0)
    if watched is not None and watch is None:
        check_writable(watched)
        write_paint(Path(watched), saved.painting)
        watch = Watch(watched, offer.size)
        notes.append(f"{watched} is new, with the painting as it is; open it in your program.")
    return Beginning(shelf, folder, replace(saved, setting=setting), scene, notes, watch)


def folder_of(offer: Offer, shelf: Shelf, folder: PaintingFolder) -> PaintingFolder:
    """Where the painting of a scene lies: within the folder, if its size is not the first one's."""
    return folder if offer.size == shelf.first.size else folder.of_size(offer.size)


def _last_offer(shelf: Shelf, name: str, notes: list[str]) -> Offer:
    """The scene that was open, or the first if that is not there any more."""
    try:
        return shelf.offer(name) if name else shelf.first
    except InputError as error:
        notes.append(f"The scene of last time is not here: {sentence(error)}")
        return shelf.first


def _opened(offer: Offer, setting: Setting, notes: list[str]) -> Scene:
    """A scene with the layers that were picked, or the usual ones if they are not there."""
    picked = setting.layers.get(offer.name, ())
    try:
        return offer.read(picked)
    except InputError as error:
        if not picked:
            raise
        notes.append(f"The layers of last time are not here: {sentence(error)}")
        return offer.read()
