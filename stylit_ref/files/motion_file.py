"""Motion vectors as files hold them, before anything is said about their signs and direction.

===========  ===================================================================
``flo``      a ``.flo`` file
``blender``  a layer ``Vector`` with X, Y, Z, W: Blender's pass, of versions 4
             and 5, in one part or in many
``nuke``     layers ``forward`` and ``backward`` with u and v
``own``      a layer ``MOTION`` with X and Y, and ``VISIBLE`` with Y
``other``    any other layer that is named, or the only one: its first two
             channels
===========  ===================================================================
"""

from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import split_layer
from stylit_ref.files.layers.contents import Contents, contents_of
from stylit_ref.files.layers.layer import Layer
from stylit_ref.files.layers.names import find_layer, fitting
from stylit_ref.files.layers.pixels import read_layer
from stylit_ref.files.motion_flo import UNKNOWN, read_flo

FLO, BLENDER, NUKE, OWN, OTHER = "flo", "blender", "nuke", "own", "other"


class Vectors(NamedTuple):
    """Vectors as a file holds them.

    Attributes
    ----------
    pairs : tuple of (H, W, 2) float32 or None
        Blender and Nuke have two pairs of channels, one for each direction in time; Nuke's may lack
        one. All values are finite.
    known : tuple of (H, W) bool or None
        Of each pair, whether the pixel has a vector.
    visible : (H, W) bool or None
        Whether the other frame shows the pixel's point; None where the file does not tell.
    dialect : {"flo", "blender", "nuke", "own", "other"}
        What the names of file and channels say.
    """

    pairs: tuple[NDArray[np.float32] | None, ...]
    known: tuple[NDArray[np.bool_] | None, ...]
    visible: NDArray[np.bool_] | None
    dialect: str


def read_vectors(path: str | Path) -> Vectors:
    """Read the vectors of a file, as they are stored.

    Parameters
    ----------
    path : str or Path
        ``.flo``, or an EXR; ``file.exr:LAYER`` names a layer.

    Returns
    -------
    Vectors

    Raises
    ------
    InputError
        If the file cannot be read, or holds no vectors.
    """
    file, name = split_layer(path)
    if file.suffix.lower() == ".flo":
        pair = read_flo(file)
        return _vectors((pair,), None, FLO)
    contents = contents_of(file)
    if name is None:
        found = _own(path, contents) or _nuke(path, contents) or _blender(path, contents)
        if found:
            return found
    layer = find_layer(contents.file, name, contents)
    if layer.roles == ("X", "Y", "Z", "W"):
        return _of_blender(path, contents, layer)
    if len(layer.numbers) < 2:
        raise InputError(f"{path}: has one channel; vectors need two, right and down")
    pixels = _pixels(path, contents, layer)
    visible = _visible(path, contents) if layer.name == "MOTION" else None
    return _vectors((pixels[:, :, :2],), visible, OTHER if visible is None else OWN)


def _own(path, contents: Contents) -> Vectors | None:
    layer = next((layer for layer in contents.layers if layer.name == "MOTION"), None)
    if layer is None or layer.roles[:2] != ("X", "Y"):
        return None
    pixels = _pixels(path, contents, layer)
    return _vectors((pixels[:, :, :2],), _visible(path, contents), OWN)


def _visible(path, contents):
    layer = next((layer for layer in contents.layers if layer.name == "VISIBLE"), None)
    return None if layer is None else _pixels(path, contents, layer)[:, :, 0] >= 0.5


def _nuke(path, contents: Contents) -> Vectors | None:
    pairs = []
    for name in ("forward", "backward"):
        layers = fitting(name, [each for each in contents.layers if set(each.roles) >= set("UV")])
        pairs.append(_pixels(path, contents, layers[0])[:, :, :2] if layers else None)
    return None if all(pair is None for pair in pairs) else _vectors(tuple(pairs), None, NUKE)


def _blender(path, contents: Contents) -> Vectors | None:
    layers = [each for each in contents.layers if each.roles == ("X", "Y", "Z", "W")]
    found = fitting("Vector", layers)
    if len(found) > 1:
        names = ", ".join(layer.name for layer in found)
        raise InputError(f"{path}: has several layers of vectors; name one after a colon: {names}")
    return _of_blender(path, contents, found[0]) if found else None


def _of_blender(path, contents, layer):
    pixels = _pixels(path, contents, layer)
    return _vectors((pixels[:, :, :2], pixels[:, :, 2:]), None, BLENDER)


def _pixels(path, contents: Contents, layer: Layer) -> NDArray[np.float32]:
    pixels = read_layer(path, contents.file, layer, is_guide=True)
    if pixels.dtype != np.float32:
        raise InputError(
            f"{path}: holds whole numbers; write vectors as floating point, in an EXR or .flo file"
        )
    return pixels


def _vectors(pairs, visible, dialect):
    """Vectors whose unknown pixels are 0."""
    known = tuple(None if pair is None else (abs(pair) <= UNKNOWN).all(axis=2) for pair in pairs)
    pairs = tuple(
        None if pair is None else np.where(has_vector[:, :, None], pair, np.float32(0))
        for pair, has_vector in zip(pairs, known, strict=True)
    )
    return Vectors(pairs, known, visible, dialect)
