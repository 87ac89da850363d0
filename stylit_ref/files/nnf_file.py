"""Nearest-neighbour fields in and out, as ``.npy``."""

from pathlib import Path

import numpy as np

from stylit_ref.errors import InputError
from stylit_ref.files.output_file import check_regular, check_writable, real_path, whole_file


def read_nnf(path: str | Path) -> np.ndarray:
    """Read the array of a ``.npy`` file; whether it is a field is for others to judge.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    array
        As it was saved.

    Raises
    ------
    InputError
        If the file is missing, or is no ``.npy`` file or not a whole one.
    """
    check_regular(real_path(path))
    try:
        # Mapped first: the file is as long as its header says, before memory is taken.
        return np.array(np.lib.format.open_memmap(path, mode="r"), order="C")
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except Exception as error:  # whatever the text of a header brings NumPy's parser to
        raise InputError(f"{path}: is not a readable .npy file: {error}") from None


def check_nnf_writable(path: str | Path):
    """Refuse early an output that :func:`write_nnf` could not write.

    Raises
    ------
    InputError
    """
    if Path(path).suffix != ".npy":
        raise InputError(f"{path}: the nearest-neighbour field is written as .npy")
    check_writable(path)


def write_nnf(path: str | Path, nnf: np.ndarray):
    """Write a nearest-neighbour field, whole or not at all.

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
