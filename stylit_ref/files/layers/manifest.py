"""Names of the objects of a Cryptomatte: in the header of the file, or in a file beside it."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

_SHOWN_NAMES = 30

_LARGEST = 1 << 26
"""Bytes of a list of names; a larger file is none."""


class Manifest(NamedTuple):
    """IDs by name.

    Attributes
    ----------
    ids : dict of str to int
        Empty where no names are known.
    why_none : str
        The reason, as a sentence.
    """

    ids: dict[str, int]
    why_none: str = "the file does not list its names"

    @property
    def known_names(self) -> str:
        """The end of a sentence: which names there are."""
        if not self.ids:
            return self.why_none
        names = list(self.ids)
        more = f" and {len(names) - _SHOWN_NAMES} more" if len(names) > _SHOWN_NAMES else ""
        return f"its names are: {', '.join(names[:_SHOWN_NAMES])}{more}"


def read_manifest(file: Path, header: Mapping[str, str], key: str | None) -> Manifest:
    """Read the names of a Cryptomatte.

    Parameters
    ----------
    file : Path
    header : mapping of str to str
        What the file says about all of its Cryptomattes.
    key : str or None
        What the names of those sayings begin with that are about this one; None if there are none.

    Returns
    -------
    Manifest
        Nothing is read that lies outside the folder of the file.
    """
    if key is None:
        return Manifest({})
    sidecar = header.get(f"{key}manif_file")
    if not sidecar:
        return Manifest(_ids(header.get(f"{key}manifest", "")))
    folder = file.resolve().parent
    try:
        place = (folder / sidecar).resolve()
        if not place.is_relative_to(folder):
            return Manifest({}, f"{sidecar} with its names lies outside its folder")
        if not place.is_file() or place.stat().st_size > _LARGEST:
            return Manifest({}, f"there is no {sidecar} with its names beside it")
        ids = _ids(place.read_text(encoding="utf-8"))
    except (OSError, RuntimeError, ValueError):  # a name that cannot be one, or no text
        ids = {}
    return Manifest(ids, f"{sidecar} beside it does not list its names")


def _ids(text):
    """IDs by name, none where the text is no list of them."""
    try:
        return {name: int(number, 16) for name, number in json.loads(text).items()}
    except (AttributeError, TypeError, ValueError, RecursionError):
        return {}
