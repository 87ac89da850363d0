"""Optical flow as Middlebury keeps it: ``.flo``, the format of Sintel and of most flow programs.

Little endian: the float32 202021.25, which reads ``PIEH``, the width and the height as int32, then
u and v of every pixel as float32, row by row. A value above 1e9 says that a pixel has no vector.
"""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.disk.image_file import LARGEST_IMAGE
from stylit_ref.files.disk.paths import check_regular, existing_file
from stylit_ref.files.disk.whole_file import whole_file

MARK = b"PIEH"
UNKNOWN = 1e9
_HEADER = 12


def read_flo(path: str | Path) -> NDArray[np.float32]:
    """Read a ``.flo`` file.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    (H, W, 2) float32
        (u, v) as stored; above :data:`UNKNOWN` where a pixel has no vector.

    Raises
    ------
    InputError
        If the file is missing, is no ``.flo`` file, or is shorter or longer than its header says.
    """
    height, width = size_of_flo(path)
    try:
        values = np.frombuffer(Path(path).read_bytes(), "<f4", offset=_HEADER)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    return values.reshape(height, width, 2).astype(np.float32)


def size_of_flo(path: str | Path) -> tuple[int, int]:
    """Read the header of a ``.flo`` file.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    tuple of 2 int
        Rows and columns.

    Raises
    ------
    InputError
        As :func:`read_flo`.
    """
    file = existing_file(path)
    check_regular(file)
    try:
        with file.open("rb") as stream:
            header = stream.read(_HEADER)
        size = file.stat().st_size
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    if len(header) < _HEADER or header[:4] != MARK:
        raise InputError(f"{path}: is no .flo file: it does not begin with PIEH")
    width, height = (int(value) for value in np.frombuffer(header[4:], "<i4"))
    if width < 1 or height < 1 or 2 * width * height > LARGEST_IMAGE:
        raise InputError(f"{path}: declares {width}x{height} pixels; its header is broken")
    needed = _HEADER + 8 * width * height
    if size != needed:
        raise InputError(
            f"{path}: has {size} bytes, and {width}x{height} pixels need {needed}; write it again"
        )
    return height, width


def write_flo(path: str | Path, vectors: NDArray[np.float32]) -> None:
    """Write a ``.flo`` file; a failure leaves no partial file.

    Parameters
    ----------
    path : str or Path
    vectors : (H, W, 2) float32

    Raises
    ------
    InputError
        If it cannot be written.
    """
    height, width = vectors.shape[:2]
    header = MARK + np.array([width, height], "<i4").tobytes()
    content = header + vectors.astype("<f4").tobytes()
    with whole_file(path, len(content)) as partial:
        partial.write_bytes(content)
