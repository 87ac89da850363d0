"""A picture as it was read of a file, with what is known of its values."""

import logging
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.disk.paths import split_layer
from stylit_ref.files.layers.contents import contents_of
from stylit_ref.files.layers.cryptomatte import (
    cryptomattes_of,
    find_cryptomatte,
    find_matte,
    read_labels,
    read_matte,
)
from stylit_ref.files.layers.layer import Layer
from stylit_ref.files.layers.names import find_layer
from stylit_ref.files.layers.pixels import read_layer
from stylit_ref.notes import note


class Picture(NamedTuple):
    """What was read of a file.

    Attributes
    ----------
    pixels : (H, W, n) uint8, uint16 or float32; or uint32
        The last are labels.
    alpha_channel : int or None
        The last, if there is one.
    is_light : bool
        Whether floating point is scene-linear light; otherwise it is data.
    name : str
        Of the layer without that of its view layer, or of the file.
    words : frozenset of str
        Those of the names of the layer and its channels.
    labels : mapping of int to str, or None
        Names of the labels of a Cryptomatte, where the file lists them.
    """

    pixels: NDArray[np.uint8 | np.uint16 | np.uint32 | np.float32]
    alpha_channel: int | None
    is_light: bool
    name: str
    words: frozenset[str] = frozenset()
    labels: Mapping[int, str] | None = None

    @property
    def colours(self) -> NDArray[np.uint8 | np.uint16 | np.uint32 | np.float32]:
        """All channels but alpha."""
        return self.pixels[:, :, : self.alpha_channel]


def read_picture(path: str | Path, *, is_guide: bool = False) -> Picture:
    """Read a file, a layer, a channel or a matte, without an alpha that tells nothing.

    Parameters
    ----------
    path : str or Path
    is_guide : bool
        Whether a whole Cryptomatte is read, as labels; and as of
        :func:`~stylit_ref.files.layers.pixels.read_layer`.

    Returns
    -------
    Picture

    Raises
    ------
    InputError
        If it cannot be read.
    """
    file, name = split_layer(path)
    contents = contents_of(file)
    cryptomattes = cryptomattes_of(contents)
    cryptomatte = find_cryptomatte(name, cryptomattes) if is_guide else None
    if cryptomatte:
        names = {number: name for name, number in cryptomatte.manifest.ids.items()}
        labels = read_labels(path, file, cryptomatte)
        return Picture(labels, None, False, _last(cryptomatte.name), labels=names)
    matte = find_matte(file, name, cryptomattes)
    if matte:
        return Picture(read_matte(path, file, *matte), None, False, matte[1])
    layer = find_layer(file, name, contents)
    if contents.left_out:
        note(f"{file}: {contents.left_out}")
    pixels = read_layer(path, file, layer, is_guide=is_guide)
    alpha_channel = layer.alpha_channel
    if alpha_channel is not None:
        alpha = pixels[:, :, alpha_channel]
        opaque = 1 if alpha.dtype == np.float32 else np.iinfo(alpha.dtype).max
        if (alpha <= 0).all():
            note(f"{path}: is transparent everywhere; its alpha is left out", level=logging.WARNING)
            pixels = read_layer(path, file, layer, straight=True, is_guide=is_guide)
        if (alpha <= 0).all() or (alpha >= opaque).all():
            pixels, alpha_channel = np.ascontiguousarray(pixels[:, :, :alpha_channel]), None
    if layer.roles[:3] == ("Y", "RY", "BY"):
        pixels = _colours_of_luminance(pixels)
    known_as = _last(layer.name) if name and layer.name else file.name
    return Picture(pixels, alpha_channel, layer.is_light, known_as, layer.words)


def plain_layer(path: str | Path) -> Layer | None:
    """The layer that a path names, where its header tells all but the values of its pixels.

    Parameters
    ----------
    path : str or Path
        As of :func:`read_picture`.

    Returns
    -------
    Layer or None
        None if it has alpha, whose values decide whether it counts; and of mattes and labels.

    Raises
    ------
    InputError
        If its file cannot be read, or has no such layer.
    """
    file, name = split_layer(path)
    contents = contents_of(file)
    cryptomattes = cryptomattes_of(contents)
    if find_cryptomatte(name, cryptomattes) or find_matte(file, name, cryptomattes):
        return None
    layer = find_layer(file, name, contents)
    has_more = layer.alpha_channel is not None or layer.is_deep or layer.roles[0] == "INK0"
    return None if has_more or "uint" in layer.types else layer


def _last(name):
    return name.rpartition(".")[2]


def _colours_of_luminance(pixels):
    """Colours of luminance Y and (R - Y) / Y, (B - Y) / Y, for the primaries of sRGB."""
    luminance = pixels[:, :, 0]
    red, blue = luminance * (pixels[:, :, 1] + 1), luminance * (pixels[:, :, 2] + 1)
    green = (luminance - 0.2126 * red - 0.0722 * blue) / 0.7152
    return np.dstack([red, green, blue, pixels[:, :, 3:]])
