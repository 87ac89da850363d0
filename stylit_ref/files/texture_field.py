"""Where every pixel of a texture came from, as ``.npy``.

The first array of a file is S, (H, W, 3) int32. The second is a text, JSON with the facts
``exemplar_sizes``: height and width of each exemplar; ``iterations``; and ``idle``.
"""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.npy_file import check_arrays_writable, read_arrays, write_arrays


@dataclass(frozen=True, eq=False)
class TextureField:
    """S, the sizes of the exemplars that it points into, and what was done to make it.

    Attributes
    ----------
    coordinates : (H, W, 3) int32
        For every pixel the number of its exemplar, from 0, and y and x in quarters of a pixel.
    exemplar_sizes : tuple of (int, int)
        Height and width of each.
    iterations : int
        How many were done, so that a session goes on with the next.
    idle : int
        How many of them, up to the last, changed nothing.
    """

    coordinates: NDArray[np.int32]
    exemplar_sizes: tuple[tuple[int, int], ...]
    iterations: int = 0
    idle: int = 0


def read_texture_field(path: str | Path) -> TextureField:
    """Read a field that :func:`write_texture_field` wrote.

    Raises
    ------
    InputError
        If the file is missing, incomplete, or holds something else.
    """
    return read_arrays(path, _checked)


def check_texture_field_writable(path: str | Path) -> None:
    """Refuse a path that :func:`write_texture_field` could not write, before the work begins.

    Raises
    ------
    InputError
    """
    check_arrays_writable(path, "saved coordinates")


def write_texture_field(path: str | Path, field: TextureField) -> None:
    """Write a field; a failure leaves no partial file.

    Parameters
    ----------
    path : str or Path
        Ends in ``.npy``. ``numpy.load`` reads the coordinates from it.
    field : TextureField

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    facts = {
        "exemplar_sizes": field.exemplar_sizes,
        "iterations": field.iterations,
        "idle": field.idle,
    }
    write_arrays(path, [field.coordinates, np.array(json.dumps(facts))])


def _checked(coordinates, rest):
    if coordinates.dtype != np.int32 or coordinates.ndim != 3 or coordinates.shape[2] != 3:
        raise ValueError(
            f"it holds {coordinates.dtype} of shape {coordinates.shape}, and coordinates of a "
            "texture are int32 of shape (H, W, 3)"
        )
    if not rest or not coordinates.size:
        raise ValueError("it does not say of which exemplars it is")
    facts = json.loads(str(rest[0]))
    sizes = [tuple(map(int, size)) for size in facts["exemplar_sizes"]]
    if not sizes or any(len(size) != 2 or min(size) < 1 for size in sizes):
        raise ValueError(f"the sizes of its exemplars are {sizes}")
    index, y, x = np.moveaxis(coordinates, -1, 0)
    if index.min() < 0 or index.max() >= len(sizes):
        raise ValueError(f"it points to an exemplar that is none of its {len(sizes)}")
    height, width = np.moveaxis(np.array(sizes)[index] * 4, -1, 0)
    if ((y < 0) | (y >= height) | (x < 0) | (x >= width)).any():
        raise ValueError("it points outside its exemplars")
    done = [facts["iterations"], facts["idle"]]
    if not all(isinstance(number, int) and number >= 0 for number in done):
        raise ValueError(f"the iterations done, and those without a change, are {done}")
    return TextureField(coordinates, tuple(sizes), *done)
