"""What a channel is for, as its name says: ``LAYER.R``, ``paint.red``, ``Diffuse_R``, ``Z``."""

import re
from collections import defaultdict
from collections.abc import Sequence, Set

_SPELLED_OUT = {"RED": "R", "GREEN": "G", "BLUE": "B", "ALPHA": "A"}
_WITHOUT_A_DOT = re.compile(
    r"(.+?)(?:[_ -](?i:(red|green|blue|alpha|[rgbaxyz]))"
    r"|(Red|Green|Blue|Alpha|[RGBAXYZ]))"
)
_DATA = {
    "crypto", "cryptomatte", "depth", "disparity", "id", "idmask", "ids", "index", "mask", "masks",
    "matte", "mattes", "mist", "normal", "normals", "pos", "position", "positions", "uv", "vector",
    "vectors", "velocity", "z",
}  # fmt: skip
_LABELS = {
    "id", "ids", "index", "indexma", "indexob", "materialid", "matid", "objectid", "objid",
}  # fmt: skip
_WORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])")


def split_names(names: Sequence[str]) -> list[tuple[str, str]]:
    """Split names of channels into layer and role.

    Parameters
    ----------
    names : sequence of str
        Those of one part of a file.

    Returns
    -------
    list of (layer, role)
        A role is ``R``, ``G``, ``B`` or ``A`` if the name says that in one way or another, and
        otherwise the channel's name in capital letters. A channel without a layer has layer ``""``.
    """
    split = []
    for name in names:
        layer, _, channel = name.rpartition(".")
        split.append((layer, _role(channel)))
    # A name without a dot has a layer only where its fellows complete a colour or a vector.
    guesses = {}
    found = defaultdict(set)
    for number, name in enumerate(names):
        match = _WITHOUT_A_DOT.fullmatch(name)
        if match and "." not in name:
            guesses[number] = match[1], _role(match[2] or match[3])
            found[match[1]].add(guesses[number][1])
    for number, (layer, role) in guesses.items():
        if found[layer] >= set("RGB") or found[layer] >= set("XYZ"):
            split[number] = layer, role
    return split


def choose(roles: Sequence[str]) -> tuple[list[int], bool]:
    """Choose the channels of a layer that are read, in their usual order.

    These are its colours if it has any, else its luminance with what tells the colours from it,
    and alpha as the last; else all of its channels, in the file's order where their names say
    nothing.

    Parameters
    ----------
    roles : sequence of str

    Returns
    -------
    chosen : list of int
        Indices into ``roles``.
    is_light : bool
        Whether they are colours or luminance; otherwise they are data.
    """
    place = {role: number for number, role in reversed(list(enumerate(roles)))}
    if place.keys() & {"R", "G", "B"}:
        return [place[role] for role in ("R", "G", "B", "A") if role in place], True
    if "Y" in place and "X" not in place:  # luminance, not a coordinate
        return [place[role] for role in ("Y", "RY", "BY", "A") if role in place], True
    order = "XYZWUVA" if set(roles) <= set("XYZWUVA") else "A"
    return sorted(range(len(roles)), key=lambda number: order.find(roles[number])), False


def is_data(layer: str) -> bool:
    """Whether the name of a layer says that it is no light: depth, normals, IDs, masks, ..."""
    return not _DATA.isdisjoint(words_of(layer.rpartition(".")[2]))


def are_labels(words: Set[str]) -> bool:
    """Whether the words of a layer's names say that its whole numbers are indices or IDs."""
    return not _LABELS.isdisjoint(words)


def words_of(name: str) -> set[str]:
    """The words of a name in small letters: ``Object Index``, ``objectIndex``, ``OBJECT_INDEX``."""
    return {word.lower() for word in _WORD.findall(name)}


def _role(channel):
    return _SPELLED_OUT.get(channel.upper(), channel.upper())
