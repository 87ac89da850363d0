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
from stylit_ref.files.motion_flo import UNKNOWN, read_flo, size_of_flo

FLO, BLENDER, NUKE, OWN, OTHER = "flo", "blender", "nuke", "own", "other"
_OF_BLENDER = "X", "Y", "Z", "W"
_WHOLE_NUMBERS = {"uint8", "uint16", "uint"}


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


class VectorsLook(NamedTuple):
    """What the header of a file tells of its vectors.

    Attributes
    ----------
    size : tuple of 2 int
        Rows and columns.
    pairs : tuple of bool
        As of :class:`Vectors`: whether the file has the channels of each pair.
    dialect : str
        As of :class:`Vectors`.
    """

    size: tuple[int, int]
    pairs: tuple[bool, ...]
    dialect: str


def look_at_vectors(path: str | Path) -> VectorsLook:
    """Read the header of a file of vectors.

    Parameters
    ----------
    path : str or Path
        As of :func:`read_vectors`.

    Returns
    -------
    VectorsLook

    Raises
    ------
    InputError
        If it cannot be read, or holds no vectors.
    """
    file, name = split_layer(path)
    if file.suffix.lower() == ".flo":
        return VectorsLook(size_of_flo(file), (True,), FLO)
    stored = _stored(path, contents_of(file), name)
    size = next(layer.size for layer in stored.layers if layer)
    has_pair = tuple(layer is not None for layer in stored.layers)
    return VectorsLook(
        size, (True, True) if stored.dialect == BLENDER else has_pair, stored.dialect
    )


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
        return _vectors((read_flo(file),), None, FLO)
    stored = _stored(path, contents_of(file), name)
    pixels = [layer and _pixels(path, file, layer) for layer in stored.layers]
    if stored.dialect == BLENDER:
        pairs = pixels[0][:, :, :2], pixels[0][:, :, 2:]
    else:
        pairs = tuple(None if each is None else each[:, :, :2] for each in pixels)
    visible = stored.visible and _pixels(path, file, stored.visible)[:, :, 0] >= 0.5
    return _vectors(pairs, visible, stored.dialect)


class _Stored(NamedTuple):
    """Which layers hold vectors: Blender's both pairs, any other one pair each."""

    dialect: str
    layers: tuple[Layer | None, ...]
    visible: Layer | None = None


def _stored(path, contents: Contents, name: str | None) -> _Stored:
    found = None
    if name is None:
        found = _own(contents) or _nuke(contents) or _blender(path, contents)
    stored = found or _named(path, contents, name)
    for layer in stored.layers:
        if layer and set(layer.types) <= _WHOLE_NUMBERS:
            raise InputError(
                f"{path}: holds whole numbers; write vectors as floating point, in an EXR or .flo "
                "file"
            )
    return stored


def _own(contents: Contents) -> _Stored | None:
    layer = next((layer for layer in contents.layers if layer.name == "MOTION"), None)
    if layer is None or layer.roles[:2] != ("X", "Y"):
        return None
    return _Stored(OWN, (layer,), _visible(contents))


def _visible(contents):
    return next((layer for layer in contents.layers if layer.name == "VISIBLE"), None)


def _nuke(contents: Contents) -> _Stored | None:
    layers = []
    for name in ("forward", "backward"):
        found = fitting(name, [each for each in contents.layers if set(each.roles) >= set("UV")])
        layers.append(found[0] if found else None)
    return _Stored(NUKE, tuple(layers)) if any(layers) else None


def _blender(path, contents: Contents) -> _Stored | None:
    layers = [each for each in contents.layers if each.roles == _OF_BLENDER]
    found = fitting("Vector", layers)
    if len(found) > 1:
        names = ", ".join(layer.name for layer in found)
        raise InputError(f"{path}: has several layers of vectors; name one after a colon: {names}")
    return _Stored(BLENDER, (found[0],)) if found else None


def _named(path, contents: Contents, name: str | None) -> _Stored:
    layer = find_layer(contents.file, name, contents)
    if layer.roles == _OF_BLENDER:
        return _Stored(BLENDER, (layer,))
    if len(layer.numbers) < 2:
        raise InputError(f"{path}: has one channel; vectors need two, right and down")
    visible = _visible(contents) if layer.name == "MOTION" else None
    return _Stored(OWN if visible else OTHER, (layer,), visible)


def _pixels(path, file: Path, layer: Layer) -> NDArray[np.float32]:
    return read_layer(path, file, layer, is_guide=True).astype(np.float32, copy=False)


def _vectors(pairs, visible, dialect):
    """Vectors whose unknown pixels are 0."""
    known = tuple(None if pair is None else _has_vector(pair) for pair in pairs)
    pairs = tuple(
        None if pair is None else np.where(has_vector[:, :, None], pair, np.float32(0))
        for pair, has_vector in zip(pairs, known, strict=True)
    )
    return Vectors(pairs, known, visible, dialect)


def _has_vector(pair):
    right, down = abs(pair[:, :, 0]), abs(pair[:, :, 1])
    return (right <= UNKNOWN) & (down <= UNKNOWN)
