"""The manifest of ``stylit-ref views``: which files a grid of views is made of.

``docs/how_to/sequences.md`` describes it.
"""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from stylit_ref.errors import InputError, did_you_mean
from stylit_ref.files.disk.paths import check_regular, existing_file
from stylit_ref.views.frames import grid_pairs
from stylit_ref.views.interpolation.camera import read_camera
from stylit_ref.views.motion.conventions import AUTO, convention_named

VIEW, OTHER = "{view}", "{other}"
_KEYS = {
    "style": str, "guides": list, "grid": list, "pairs": list, "motion": str,
    "motion_convention": str, "depth": str, "ids": str, "cameras": dict,
    "mesh": str, "positions": str,
}  # fmt: skip
_KEYS_OF_GUIDE = {"source": str, "view": str, "weight": (int, float)}
_KINDS = {
    str: "a text", list: "a list", dict: "an object", (int, float): "a number",
}  # fmt: skip


@dataclass(frozen=True)
class Manifest:
    """Views, and which of them are neighbours. Paths are as the manifest has them, in its folder.

    Attributes
    ----------
    style : str
    source_guides : tuple of str
    guides : tuple of str
        The file of each guide, with ``{view}`` for the name of a view.
    weights : tuple of float
    views : tuple of str
    grid : tuple of 2 int, or None
        Rows and columns, if the views are a grid.
    pairs : tuple of (int, int)
        Places of a view and of a neighbour; each direction is a pair.
    motion : str or None
        With ``{view}`` and ``{other}``; the vectors lead from the one into the other.
    motion_convention : str
    depth, ids : str or None
        With ``{view}``.
    cameras : tuple of dict, or None
        What is said of the camera of each view.
    mesh : str or None
    positions : str or None
        With ``{view}``.
    """

    style: str
    source_guides: tuple[str, ...]
    guides: tuple[str, ...]
    weights: tuple[float, ...]
    views: tuple[str, ...]
    grid: tuple[int, int] | None
    pairs: tuple[tuple[int, int], ...]
    motion: str | None
    motion_convention: str
    depth: str | None
    ids: str | None
    cameras: tuple[dict[str, Any], ...] | None
    mesh: str | None
    positions: str | None


def read_manifest(path: str) -> Manifest:
    """Read a manifest.

    Raises
    ------
    InputError
        If it cannot be read, lacks something, or has a key that means nothing.
    """
    file = existing_file(path)
    check_regular(file)
    try:
        return _manifest(json.loads(file.read_text(encoding="utf-8")), file.parent)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
    except ValueError as error:
        raise InputError(f"{path}: is no JSON: {error}") from None


def _manifest(content: Any, folder: Path) -> Manifest:
    values = _checked(content, "it", _KEYS, ("style", "guides"))
    guides = [
        _checked(guide, f"guide {number}", _KEYS_OF_GUIDE, ("source", "view"))
        for number, guide in enumerate(values["guides"], 1)
    ]
    if not guides:
        raise InputError("guides is empty; at least one is needed")
    if ("grid" in values) == ("pairs" in values):
        raise InputError("either grid, which has rows of views, or pairs of neighbours is needed")
    rows = values.get("grid")
    views, pairs = _of_grid(rows) if rows is not None else _of_pairs(values["pairs"])
    motion = values.get("motion")
    convention = values.get("motion_convention", AUTO)
    if convention != AUTO:
        convention_named(convention)
    cameras = values.get("cameras", {})
    if strange := [name for name in cameras if name not in views]:
        raise InputError(f"cameras has {strange[0]!r}, which is none of the views")
    if not all(isinstance(camera, dict) for camera in cameras.values()):
        raise InputError("each of cameras must be an object")
    if cameras and ("mesh" in values or "positions" in values):
        for view in views:
            read_camera(cameras.get(view), view)  # or InputError, before anything is drawn
    if "mesh" in values and "positions" in values:
        raise InputError("mesh and positions tell the same; leave positions out")
    beside = [values.get(key) for key in ("depth", "ids", "positions")]
    templates = [*(guide["view"] for guide in guides), *beside]
    needed = [(text, VIEW) for text in (*templates, motion)] + [(motion, OTHER)]
    for text, name in needed:
        if text is not None and name not in text:
            raise InputError(f"{text!r} lacks {name}, where the name of a view stands")
    return Manifest(
        str(folder / values["style"]),
        tuple(str(folder / guide["source"]) for guide in guides),
        tuple(str(folder / guide["view"]) for guide in guides),
        tuple(float(guide.get("weight", 1)) for guide in guides),
        views,
        (len(rows), len(rows[0])) if rows is not None else None,
        pairs,
        None if motion is None else str(folder / motion),
        convention,
        *(None if text is None else str(folder / text) for text in beside[:2]),
        tuple(cameras.get(view, {}) for view in views) if cameras else None,
        *(None if text is None else str(folder / text) for text in (values.get("mesh"), beside[2])),
    )


def _checked(value, what, keys, needed) -> dict[str, Any]:
    """An object whose keys are known, and whose values are of their kinds."""
    if not isinstance(value, dict):
        raise InputError(f"{what} is not an object with the keys {', '.join(keys)}")
    if strange := [key for key in value if key not in keys]:
        known = f"known are {', '.join(keys)}{did_you_mean(strange[0], keys)}"
        raise InputError(f"{what} has {strange[0]!r}; {known}")
    for key in needed:
        if key not in value:
            raise InputError(f"{what} lacks {key!r}")
    for key, each in value.items():
        if not isinstance(each, keys[key]) or isinstance(each, bool):
            raise InputError(f"{key} of {what} is {each!r}; it must be {_KINDS[keys[key]]}")
    return value


def _of_grid(rows: Sequence[Any]) -> tuple[tuple[str, ...], tuple[tuple[int, int], ...]]:
    _check_names(rows, "grid", "a list of rows, each with as many names of views")
    views = tuple(name for row in rows for name in row)
    if len(set(map(len, rows))) != 1 or len(set(views)) != len(views):
        raise InputError("the rows of grid must be equally long, and no view may be there twice")
    return views, tuple(grid_pairs(len(rows), len(rows[0])))


def _of_pairs(pairs: Sequence[Any]) -> tuple[tuple[str, ...], tuple[tuple[int, int], ...]]:
    _check_names(pairs, "pairs", "a list of pairs: the names of a view and of a neighbour")
    if any(len(pair) != 2 or pair[0] == pair[1] for pair in pairs):
        raise InputError("each of pairs must name two views")
    views = tuple(dict.fromkeys(name for pair in pairs for name in pair))
    return views, tuple(dict.fromkeys((views.index(to), views.index(other)) for to, other in pairs))


def _check_names(rows, key, described):
    are_lists = rows and all(isinstance(row, list) and row for row in rows)
    if not are_lists or not all(isinstance(name, str) and name for row in rows for name in row):
        raise InputError(f"{key} must be {described}")
