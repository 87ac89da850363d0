"""Meshes in Wavefront's ``.obj``, which every program of architects and artists writes."""

from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import check_regular, existing_file

_NEW_PART = {"o", "g", "usemtl"}


class MeshArrays(NamedTuple):
    """A mesh as a file holds it.

    Attributes
    ----------
    vertices : (V, 3) float64
    faces : (T, 3) int32
        Triangles; those of a polygon fan out from its first corner.
    parts : (T,) int32
        A number for each object, group and material.
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]
    parts: NDArray[np.int32]


def read_obj(path: str | Path) -> MeshArrays:
    """Read the vertices and faces of an ``.obj`` file; whatever else it holds is passed over.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    MeshArrays

    Raises
    ------
    InputError
        If it cannot be read, or a line of it is broken.
    """
    file = existing_file(str(path))
    check_regular(file)
    try:
        lines = file.read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    vertices: list[list[float]] = []
    faces: list[tuple[int, int, int]] = []
    parts: list[int] = []
    names: dict[tuple[str, str], int] = {}
    owner = {"o": "", "g": "", "usemtl": ""}
    for number, line in enumerate(lines, 1):
        word, *values = line.split() or [""]
        try:
            if word == "v":
                vertices.append([float(value) for value in values[:3]])
                if len(values) < 3:
                    raise ValueError
            elif word == "f":
                corners = [_corner(value, len(vertices)) for value in values]
                fan = list(pairwise(corners[1:]))
                faces += [(corners[0], second, third) for second, third in fan]
                parts += [names.setdefault(tuple(owner.values()), len(names))] * len(fan)
            elif word in _NEW_PART:
                owner[word] = " ".join(values)
        except (ValueError, IndexError):
            raise InputError(
                f"{path}: its line {number} is broken: {line.strip()[:60]!r}; export the scene "
                "again"
            ) from None
    return MeshArrays(
        np.array(vertices, np.float64).reshape(-1, 3),
        np.array(faces, np.int32).reshape(-1, 3),
        np.array(parts, np.int32),
    )


def _corner(value: str, vertices: int) -> int:
    """The vertex of ``7``, ``7/1/2``, or ``-1`` for the last one."""
    number = int(value.partition("/")[0])
    if not 0 < abs(number) <= vertices:
        raise ValueError
    return number - 1 if number > 0 else vertices + number
