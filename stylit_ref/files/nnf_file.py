"""Read and write nearest-neighbour fields as ``.npy``.

A ``.npy`` file may hold several arrays one after the other; ``numpy.load`` reads the first. Here

1. the first is the field, (H_B, W_B, 2) int32;
2. the second is a text, JSON with the facts of the run: ``patch_width``, ``vote_outliers``,
   ``style_size`` (height and width), ``has_mask`` and ``guide_encodings``;
3. the third, if ``has_mask`` is true, is the mask, (H_B, W_B) bool.

Files with the first alone are read too: earlier versions wrote them, and ``numpy.save`` does.
"""

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.field import Field
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.npy_file import check_arrays_writable, read_arrays, write_arrays


def read_nnf(path: str | Path) -> Field:
    """Read a field; :func:`stylit_ref.replay` checks whether its array is a valid one.

    Parameters
    ----------
    path : str or Path
        A file of :func:`write_nnf`, or of ``numpy.save``.

    Returns
    -------
    Field
        Of a file with one array, that array alone.

    Raises
    ------
    InputError
        If the file is missing, incomplete, or not a ``.npy`` file.
    """
    return read_arrays(path, made_field)


def made_field(nnf: NDArray[np.int32], rest: list[NDArray[Any]]) -> Field:
    """The field of the arrays in a file; ValueError or KeyError if they make none."""
    return _with_its_run(nnf, rest) if rest else Field(nnf)


def check_nnf_writable(path: str | Path) -> None:
    """Refuse a path that :func:`write_nnf` could not write, before the work begins.

    Raises
    ------
    InputError
    """
    check_arrays_writable(path, "a nearest-neighbour field")


def write_nnf(path: str | Path, field: Field) -> None:
    """Write a field and its run; a failure leaves no partial file.

    Parameters
    ----------
    path : str or Path
        Ends in ``.npy``. ``numpy.load`` reads the field from it.
    field : Field

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    facts = {
        "patch_width": field.patch_width,
        "vote_outliers": field.vote_outliers,
        "style_size": field.style_size,
        "has_mask": field.mask is not None,
        "guide_encodings": [encoding.to_dict() for encoding in field.guide_encodings],
    }
    arrays = [field.nnf, np.array(json.dumps(facts, default=int))]
    if field.mask is not None:
        arrays.append(field.mask)
    write_arrays(path, arrays)


def _with_its_run(nnf, rest):
    """The field with what follows its array in the file."""
    facts = json.loads(str(rest[0]))
    if "spacing" in facts:
        raise ValueError("it is of --method realtime, and has no entry for every pixel")
    width, outliers, size = (facts[name] for name in ("patch_width", "vote_outliers", "style_size"))
    numbers = [outliers, *(size or ()), *([] if width is None else [width])]
    if any(type(number) is not int or number < 0 for number in numbers) or len(size or "HW") != 2:
        raise ValueError(f"the facts of its run are {facts}")
    mask = rest[1] if facts["has_mask"] else None
    if mask is not None and (mask.dtype != bool or mask.shape != nnf.shape[:2]):
        raise ValueError(f"its mask is {mask.dtype} of shape {mask.shape}")
    encodings = tuple(map(GuideEncoding.from_dict, facts["guide_encodings"]))
    return Field(nnf, width, outliers, None if size is None else tuple(size), mask, encodings)
