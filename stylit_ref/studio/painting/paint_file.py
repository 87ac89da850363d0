"""The painting as a file: opaque RGB of 8 bits."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from stylit_ref.errors import InputError
from stylit_ref.files.disk.whole_file import whole_file
from stylit_ref.files.read_image import read_uint8


def read_paint(file: str | Path, size: tuple[int, int] | None = None) -> NDArray[np.uint8]:
    """Read a painting that any program has saved; what is transparent shows white paper.

    Parameters
    ----------
    file : str or Path
    size : tuple of int, optional
        Height and width that it must have.

    Returns
    -------
    (H, W, 3) uint8

    Raises
    ------
    InputError
        If it cannot be read, or has another size.
    """
    image = read_uint8(file)
    if size is not None and image.shape[:2] != size:
        (height, width), (wanted_height, wanted_width) = image.shape[:2], size
        raise InputError(
            f"{file}: is {width}x{height}, but the painting is {wanted_width}x{wanted_height}; "
            "make it that size"
        )
    if image.shape[2] in (2, 4):  # colours are multiplied by alpha
        image = image[:, :, :-1] + (255 - image[:, :, -1:])
    return np.ascontiguousarray(np.broadcast_to(image, (*image.shape[:2], 3)))


def write_paint(file: Path, painting: NDArray[np.uint8]) -> None:
    """Write a painting as PNG, quickly rather than small; a failure leaves no partial file.

    Parameters
    ----------
    file : Path
    painting : (H, W, 3) uint8

    Raises
    ------
    InputError
        If it cannot be written.
    """
    with whole_file(file, painting.nbytes + 2**16) as partial:
        Image.fromarray(painting).save(partial, format="PNG", compress_level=1)
