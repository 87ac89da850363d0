"""The layers of a folder of images, or of one file, by what they are called on both sides."""

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import real_path
from stylit_ref.files.layers.contents import contents_of
from stylit_ref.files.layers.cryptomatte import cryptomattes_of
from stylit_ref.realtime.packing.named_buffers import roles_of

SUFFIXES = (
    ".png", ".exr", ".tif", ".tiff", ".jpg", ".jpeg", ".webp", ".bmp", ".tga", ".hdr", ".psd",
)  # fmt: skip
"""Of the files in a folder that are taken for images."""


class FoundLayer(NamedTuple):
    """A layer of a file.

    Attributes
    ----------
    path : str
        As a command line names it.
    is_picture : bool
        Whether it holds colours.
    tells_things_apart : bool
        Whether it holds labels.
    size : tuple of 2 int
        Rows and columns.
    """

    path: str
    is_picture: bool
    tells_things_apart: bool
    size: tuple[int, int]


def layers_in(path: str | Path) -> dict[str, FoundLayer]:
    """Find the layers of a folder's images, or of a file.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    dict of str to FoundLayer
        By the name of the buffer: ``FULL`` of ``FULL.png``, ``sphere_full.png`` or
        ``scene.exr:FULL``. Of several with one name the first is taken.

    Raises
    ------
    InputError
        If there is no such file or folder, or it cannot be read.
    """
    place = real_path(path)
    if not place.exists():
        raise InputError(f"{path}: no such file or folder")
    files = [Path(path)]
    if place.is_dir():
        files = sorted(file for file in Path(path).iterdir() if file.suffix.lower() in SUFFIXES)
    found: dict[str, FoundLayer] = {}
    for file in files:
        for name, layer in _layers_of(file):
            found.setdefault(roles_of([name], ())[0], layer)
    if not found:
        raise InputError(f"{path}: holds no images; name a folder of render passes, or an EXR file")
    return found


def _layers_of(file: Path) -> Iterator[tuple[str, FoundLayer]]:
    """The names of a file's layers, or its own if it has a single one."""
    contents = contents_of(file)
    cryptomattes = cryptomattes_of(contents)
    ranks = [layer for cryptomatte in cryptomattes for layer in cryptomatte.ranks]
    previews = {cryptomatte.name for cryptomatte in cryptomattes}
    layers = [
        layer
        for layer in contents.layers
        if not layer.is_deep and layer not in ranks and layer.name not in previews
    ]
    is_alone = len(layers) + len(cryptomattes) == 1
    for layer in layers:
        path = f"{file}:{layer.name}" if layer.name else str(file)
        name = file.stem if is_alone or not layer.name else layer.name
        yield name, FoundLayer(path, layer.is_light, layer.may_be_labels, layer.size)
    for cryptomatte in cryptomattes:
        size = cryptomatte.ranks[0].size
        yield cryptomatte.name, FoundLayer(f"{file}:{cryptomatte.name}", False, True, size)
