"""Read and write nearest-neighbour fields as ``.npy``.

A ``.npy`` file may hold several arrays one after the other; ``numpy.load`` reads the first. Here

1. the first is the field, (H_B, W_B, 2) int32;
2. the second is a text, JSON with the facts of the run: ``patch_width``, ``vote_outliers``,
   ``style_size`` (height and width), ``has_mask`` and ``guide_encodings``;
3. the third, if ``has_mask`` is true, is the mask, (H_B, W_B) bool.

Files with the first alone are read too: earlier versions wrote them, and ``numpy.save`` does.
"""

import io
import json
from pathlib import Path

import numpy as np

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import check_regular, check_writable, real_path
from stylit_ref.files.disk.whole_file import whole_file
from stylit_ref.files.field import Field
from stylit_ref.files.guides.encoding import GuideEncoding


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
    check_regular(real_path(path))
    try:
        # Mapping the file checks that it is as long as its header says, before memory is taken.
        mapped = np.lib.format.open_memmap(path, mode="r")
        with open(path, "rb") as file:
            file.seek(mapped.offset + mapped.nbytes)
            rest = io.BytesIO(file.read())
        nnf = np.array(mapped, order="C")
        return _with_its_run(nnf, rest) if rest.getbuffer() else Field(nnf)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except Exception as error:  # a broken header can make NumPy's parser raise anything
        raise InputError(f"{path}: is not a readable .npy file: {error}") from None


def check_nnf_writable(path: str | Path) -> None:
    """Refuse a path that :func:`write_nnf` could not write, before the work begins.

    Raises
    ------
    InputError
    """
    if Path(path).suffix != ".npy":
        raise InputError(f"{path}: the file name of a nearest-neighbour field must end in .npy")
    check_writable(path)


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
    size = sum(array.nbytes for array in arrays)
    with whole_file(path, size + 2**12) as partial, partial.open("wb") as file:
        for array in arrays:
            np.save(file, array)


def _with_its_run(nnf, rest):
    """The field with what follows its array in the file."""
    facts = json.loads(str(np.lib.format.read_array(rest)))
    width, outliers, size = (facts[name] for name in ("patch_width", "vote_outliers", "style_size"))
    numbers = [outliers, *(size or ()), *([] if width is None else [width])]
    if any(type(number) is not int or number < 0 for number in numbers) or len(size or "HW") != 2:
        raise ValueError(f"the facts of its run are {facts}")
    mask = np.lib.format.read_array(rest) if facts["has_mask"] else None
    if mask is not None and (mask.dtype != bool or mask.shape != nnf.shape[:2]):
        raise ValueError(f"its mask is {mask.dtype} of shape {mask.shape}")
    encodings = tuple(map(GuideEncoding.from_dict, facts["guide_encodings"]))
    return Field(nnf, width, outliers, None if size is None else tuple(size), mask, encodings)
