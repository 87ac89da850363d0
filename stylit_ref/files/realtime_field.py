"""Nearest-neighbour fields of stylization in real time, as ``.npy``.

The first array of a file is the field, (rows, columns, 2) int32: an entry for each patch of the
sparse grid. The second is a text, JSON with the facts ``patch_width``, ``spacing``,
``style_size``, ``target_size`` and ``guide_encodings``.
"""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.field import Field
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.nnf_file import made_field
from stylit_ref.files.npy_file import read_arrays, write_arrays


@dataclass(frozen=True, eq=False)
class RealtimeField:
    """A sparse NNF, and what a picture is made of it by.

    Attributes
    ----------
    nnf : (rows, columns, 2) int32
        y and x of the source for every entry of the grid.
    patch_width : int
    spacing : int
        Pixels from entry to entry.
    style_size, target_size : tuple of (int, int)
        Height and width.
    guide_encodings : tuple of GuideEncoding
        How the guides became 8 bits, from :func:`stylit_ref.read_guides`; empty where that is not
        known.
    """

    nnf: NDArray[np.int32]
    patch_width: int
    spacing: int
    style_size: tuple[int, int]
    target_size: tuple[int, int]
    guide_encodings: tuple[GuideEncoding, ...] = ()


def read_any_field(path: str | Path) -> Field | RealtimeField:
    """Read what :func:`write_realtime_field` or :func:`stylit_ref.write_nnf` wrote.

    Raises
    ------
    InputError
        If the file is missing, incomplete, or holds something else.
    """
    return read_arrays(path, _made)


def write_realtime_field(path: str | Path, field: RealtimeField) -> None:
    """Write a field; a failure leaves no partial file.

    Parameters
    ----------
    path : str or Path
        Ends in ``.npy``. ``numpy.load`` reads the NNF from it.
    field : RealtimeField

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    facts = {
        "patch_width": field.patch_width,
        "spacing": field.spacing,
        "style_size": field.style_size,
        "target_size": field.target_size,
        "guide_encodings": [encoding.to_dict() for encoding in field.guide_encodings],
    }
    write_arrays(path, [field.nnf, np.array(json.dumps(facts))])


def _made(nnf, rest):
    facts = json.loads(str(rest[0])) if rest else {}
    return _checked(nnf, facts) if "spacing" in facts else made_field(nnf, rest)


def _checked(nnf, facts):
    sizes = tuple(facts["style_size"]), tuple(facts["target_size"])
    numbers = [facts["patch_width"], facts["spacing"], *sizes[0], *sizes[1]]
    if any(type(number) is not int or number < 1 for number in numbers):
        raise ValueError(f"the facts of its run are {facts}")
    (height, width), (rows, columns) = sizes
    grid = -(-rows // facts["spacing"]), -(-columns // facts["spacing"])
    if nnf.dtype != np.int32 or nnf.shape != (*grid, 2):
        raise ValueError(
            f"it holds {nnf.dtype} of shape {nnf.shape}, and its run int32 of shape {(*grid, 2)}"
        )
    if (nnf < 0).any() or (nnf >= (height, width)).any():
        raise ValueError("it points outside its style")
    encodings = tuple(map(GuideEncoding.from_dict, facts["guide_encodings"]))
    return RealtimeField(nnf, facts["patch_width"], facts["spacing"], *sizes, encodings)
