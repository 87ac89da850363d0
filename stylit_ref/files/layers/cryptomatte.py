"""Mattes of single objects, from layers that a renderer wrote as Cryptomatte.

A pixel has pairs of an ID and a coverage, spread over the layers ``NAME00``, ``NAME01``, ... An ID
is the hash of an object's name, whose bits are stored as those of a float.
"""

import logging
import re
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.layers.contents import Contents
from stylit_ref.files.layers.layer import Layer
from stylit_ref.files.layers.manifest import Manifest, read_manifest
from stylit_ref.files.layers.murmur_hash import murmur_hash
from stylit_ref.files.layers.names import fitting, whole_name
from stylit_ref.files.layers.pixels import read_layer
from stylit_ref.notes import note

_RANK = re.compile(r"\d\d(\.[^.]+)?$")
"""What a layer's name, or a channel's, has more than its Cryptomatte's."""


class Cryptomatte(NamedTuple):
    """Layers that belong together, and what their IDs mean.

    Attributes
    ----------
    name : str
        For instance ``ViewLayer.CryptoObject``.
    ranks : tuple of Layer
        Layers of IDs and coverages; those that cover most come first.
    manifest : Manifest
    also : tuple of str
        It answers to no other name.
    """

    name: str
    ranks: tuple[Layer, ...]
    manifest: Manifest
    also: tuple[str, ...] = ()


def cryptomattes_of(contents: Contents) -> list[Cryptomatte]:
    """Those of a file, as its header tells, or the names of its layers."""
    said = contents.cryptomatte
    keys = {said[key]: key.removesuffix("name") for key in said if key.endswith("/name")}
    ranks: dict[str, list[Layer]] = {}
    for layer in contents.layers:
        name, rank = layer.name[:-2], layer.name[-2:]
        if rank.isdecimal() and (name in keys or "crypto" in name.casefold()):
            ranks.setdefault(name, []).append(layer)
    return [
        Cryptomatte(
            name,
            tuple(sorted(layers, key=lambda layer: layer.name)),
            read_manifest(contents.file, said, keys.get(name)),
        )
        for name, layers in ranks.items()
    ]


def find_matte(
    file: Path, typed: str | None, cryptomattes: list[Cryptomatte]
) -> tuple[Cryptomatte, str] | None:
    """Find the matte that ``CryptoObject/NAME`` names.

    Parameters
    ----------
    file : Path
    typed : str or None
        What was written after the colon.
    cryptomattes : list of Cryptomatte
        Those of the file.

    Returns
    -------
    (Cryptomatte, str) or None
        It and the object's name, or None if ``typed`` names something else.

    Raises
    ------
    InputError
        If it names a whole Cryptomatte, several of them, or an object that is not there.
    """
    layer, _, name = (typed or "").partition("/")
    found = fitting(layer, cryptomattes) or fitting(_RANK.sub("", layer), cryptomattes)
    if not found:
        return None
    if len(found) > 1:
        several = ", ".join(whole_name(file, f"{each.name}/{name}") for each in found)
        raise InputError(f"{file}: '{layer}' fits several layers; write one of these: {several}")
    cryptomatte, manifest = found[0], found[0].manifest
    names = manifest.ids
    if not name:
        example = whole_name(file, f"{cryptomatte.name}/{next(iter(names), 'NAME')}")
        raise InputError(
            f"{file}:{typed}: is a Cryptomatte, which holds hashes of names; write {example} for "
            f"the matte of one; {manifest.known_names}"
        )
    if names and name not in names:
        raise InputError(f"{file}: {cryptomatte.name} has no '{name}'; {manifest.known_names}")
    return cryptomatte, name


def find_cryptomatte(typed: str | None, cryptomattes: list[Cryptomatte]) -> Cryptomatte | None:
    """The only one that a name without an object fits: ``CryptoObject`` or ``CryptoObject00``."""
    name = typed or ""
    found = fitting(name, cryptomattes) or fitting(_RANK.sub("", name), cryptomattes)
    return found[0] if len(found) == 1 else None


def read_labels(path: str | Path, file: Path, cryptomatte: Cryptomatte) -> NDArray[np.uint32]:
    """Read which object covers most of every pixel.

    Parameters
    ----------
    path : str or Path
        The file and Cryptomatte as the user wrote them.
    file : Path
    cryptomatte : Cryptomatte
        Of that file.

    Returns
    -------
    (H, W, 1) uint32
        The object's ID, 0 where what no object covers is more.

    Raises
    ------
    InputError
        If the layers cannot be read.
    """
    pairs = [_pairs(read_layer(path, file, layer)) for layer in cryptomatte.ranks]
    ids, covered = (np.concatenate(part, axis=2) for part in zip(*pairs, strict=True))
    most = covered.argmax(axis=2)[:, :, np.newaxis]
    rest = 1 - covered.sum(axis=2, keepdims=True)
    label = np.take_along_axis(ids, most, axis=2)
    return np.where(np.take_along_axis(covered, most, axis=2) >= rest, label, np.uint32(0))


def read_matte(
    path: str | Path, file: Path, cryptomatte: Cryptomatte, name: str
) -> NDArray[np.float32]:
    """Read how much of every pixel an object covers.

    Parameters
    ----------
    path : str or Path
        The file and matte as the user wrote them.
    file : Path
    cryptomatte : Cryptomatte
        Of that file.
    name : str
        The object's.

    Returns
    -------
    (H, W, 1) float32
        From 0 to 1.

    Raises
    ------
    InputError
        If the layers cannot be read, or the file lists no names and none of its pixels has this.
    """
    wanted = cryptomatte.manifest.ids.get(name, id_of(name))
    covered, is_there = 0.0, False
    for layer in cryptomatte.ranks:
        ids, shares = _pairs(read_layer(path, file, layer))
        mine = ids == wanted
        covered += np.where(mine, shares, 0).sum(axis=2, keepdims=True)
        is_there |= mine.any()
    if not is_there:
        if not cryptomatte.manifest.ids:
            raise InputError(
                f"{file}: no pixel of {cryptomatte.name} is of '{name}', and "
                f"{cryptomatte.manifest.known_names}"
            )
        note(f"{path}: covers no pixel", level=logging.WARNING)
    return np.clip(covered, 0, 1).astype(np.float32)


def id_of(name: str) -> int:
    """The ID of a name: its hash, made to be the bits of an ordinary float.

    Parameters
    ----------
    name : str

    Returns
    -------
    int
        From 0 to 2**32 - 1.
    """
    hashed = murmur_hash(name.encode())
    exponent = hashed >> 23 & 255
    # These bits would be a denormal number, an infinity or no number.
    return hashed ^ (1 << 23) if exponent in (0, 255) else hashed


def _pairs(pixels):
    """IDs and coverages of a rank."""
    shares = pixels[:, :, 1::2]
    ids = np.ascontiguousarray(pixels[:, :, 0::2]).view(np.uint32)
    return ids[:, :, : shares.shape[2]], shares
