"""An open image file: whole pixels, or the reason why there are none in one clause."""

from pathlib import Path

import numpy as np
import OpenImageIO as oiio

from stylit_ref.errors import InputError

LARGEST_IMAGE = 1 << 29
"""Values (pixels times channels) that a file may declare: 16384x8192 with 4 channels.

As floating point they take 2 GiB, and reading takes two to three times the memory of the image.
More are refused before memory is taken: a file of a few bytes can declare any size.
"""


def open_image(file: str | Path) -> oiio.ImageInput:
    """Open an image file.

    Parameters
    ----------
    file : str or Path

    Returns
    -------
    OpenImageIO.ImageInput

    Raises
    ------
    InputError
        If its format is not known, or its header is broken.
    """
    image = oiio.ImageInput.open(str(file))
    if image is None:
        raise InputError(f"{file}: cannot be read: {reason_of(oiio.geterror())}")
    return image


def check_size(file: str | Path, spec: oiio.ImageSpec):
    """Refuse by what the file declares; its display window may exceed its pixels.

    Raises
    ------
    InputError
        If that is more than :data:`LARGEST_IMAGE` values.
    """
    for width, height in ((spec.width, spec.height), (spec.full_width, spec.full_height)):
        if width * height * spec.nchannels > LARGEST_IMAGE:
            raise InputError(
                f"{file}: declares {width}x{height} pixels with {spec.nchannels} channels; "
                f"at most {LARGEST_IMAGE} values are read"
            )


def read_pixels(image: oiio.ImageInput, part: int, depth: str) -> np.ndarray | None:
    """All pixels of a part of an open file.

    Of a truncated JPEG the rest is made up, and the error alone tells.

    Parameters
    ----------
    image : OpenImageIO.ImageInput
    part : int
    depth : {"uint8", "uint16", "float", ...}
        Values are converted to it.

    Returns
    -------
    (H, W, n) array of that dtype or None
        The data window; None where it cannot be read, and ``image.geterror()`` says why.
    """
    pixels = image.read_image(part, 0, 0, image.spec().nchannels, depth)
    return None if image.has_error else pixels


def reason_of(said: str) -> str:
    """The first line of what OpenImageIO said: more are advice, or the same again."""
    return said.split("\n")[0].rstrip(".")
