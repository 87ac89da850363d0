"""``.npy`` files that hold several arrays one after the other; ``numpy.load`` reads the first."""

import io
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.lib.format import MAGIC_PREFIX
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import check_regular, check_writable, real_path
from stylit_ref.files.disk.whole_file import whole_file

Made = TypeVar("Made")


def read_arrays(path: str | Path, make: Callable[[NDArray[Any], list[NDArray[Any]]], Made]) -> Made:
    """Read the arrays of a file.

    Parameters
    ----------
    path : str or Path
    make : callable
        Called with the first array and a list of the others; what it raises becomes an InputError.

    Returns
    -------
    What ``make`` returns.

    Raises
    ------
    InputError
        If the file is missing, incomplete, or not a ``.npy`` file.
    """
    check_regular(real_path(path))
    try:
        with open(path, "rb") as file:
            if not MAGIC_PREFIX.startswith(file.read(len(MAGIC_PREFIX))):
                raise ValueError("it is a file of another kind")
            # Mapping the file checks that it is as long as its header says, before memory is taken.
            mapped = np.lib.format.open_memmap(path, mode="r")
            file.seek(mapped.offset + mapped.nbytes)
            rest = io.BytesIO(file.read())
        others = []
        while rest.tell() < len(rest.getbuffer()):
            others.append(np.lib.format.read_array(rest))
        return make(np.array(mapped, order="C"), others)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except Exception as error:  # a broken header can make NumPy's parser raise anything
        raise InputError(f"{path}: is not a readable .npy file: {error}") from None


def check_arrays_writable(path: str | Path, what: str) -> None:
    """Refuse a path that :func:`write_arrays` could not write, before the work begins.

    Raises
    ------
    InputError
    """
    if Path(path).suffix != ".npy":
        raise InputError(f"{path}: the file name of {what} must end in .npy")
    check_writable(path)


def write_arrays(path: str | Path, arrays: Sequence[NDArray[Any]]) -> None:
    """Write arrays; a failure leaves no partial file.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    size = sum(array.nbytes for array in arrays)
    with whole_file(path, size + 2**12) as partial, partial.open("wb") as file:
        for array in arrays:
            np.save(file, array)
