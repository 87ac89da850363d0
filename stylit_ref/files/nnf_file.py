"""Read and write nearest-neighbour fields as ``.npy``."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.output_file import check_regular, check_writable, real_path, whole_file


def read_nnf(path: str | Path) -> np.ndarray:
    """Read the array of a ``.npy`` file; its caller checks whether it is a valid field.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    array
        The array as it was saved.

    Raises
    ------
    InputError
        If the file is missing, incomplete, or not a ``.npy`` file.
    """
    check_regular(real_path(path))
    try:
        # Mapping the file checks that it is as long as its header says, before memory is taken.
        return np.array(np.lib.format.open_memmap(path, mode="r"), order="C")
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


def write_nnf(path: str | Path, nnf: NDArray[np.int32]) -> None:
    """Write a nearest-neighbour field; a failure leaves no partial file.

    Parameters
    ----------
    path : str or Path
        Ends in ``.npy``.
    nnf : (H_B, W_B, 2) int32

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    with whole_file(path, nnf.nbytes + 2**12) as partial:
        np.save(partial, nnf)
