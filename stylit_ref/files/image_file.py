"""Open an image file and read its pixels."""

from pathlib import Path

import numpy as np
import OpenImageIO as oiio
from numpy.typing import NDArray

from stylit_ref.errors import InputError

LARGEST_IMAGE = 1 << 29
"""Most values (pixels times channels) that a file may declare: 16384x8192 with 4 channels.

As floating point they take 2 GiB, and reading takes two to three times the memory of the image.
Larger images are refused before memory is allocated: a file of a few bytes can declare any size.
"""


def open_image(file: str | Path, *, straight: bool = False) -> oiio.ImageInput:
    """Open an image file.

    Parameters
    ----------
    file : str or Path
    straight : bool
        Whether to leave colours as the file has them where it has not multiplied them by alpha.

    Returns
    -------
    OpenImageIO.ImageInput

    Raises
    ------
    InputError
        If its format is not known, or its header is broken.
    """
    wishes = oiio.ImageSpec()
    wishes.attribute("oiio:UnassociatedAlpha", int(straight))
    image = oiio.ImageInput.open(str(file), wishes)
    if image is None:
        raise InputError(f"{file}: cannot be read: {reason_of(oiio.geterror())}")
    return image


def check_size(file: str | Path, spec: oiio.ImageSpec) -> None:
    """Refuse an image whose header declares too large a data window or display window.

    Raises
    ------
    InputError
        If either has more than :data:`LARGEST_IMAGE` values.
    """
    for width, height in ((spec.width, spec.height), (spec.full_width, spec.full_height)):
        if width * height * spec.nchannels > LARGEST_IMAGE:
            raise InputError(
                f"{file}: declares {width}x{height} pixels with {spec.nchannels} channels; at most "
                f"{LARGEST_IMAGE} values (width x height x channels) can be read; make it smaller"
            )


def read_pixels(
    image: oiio.ImageInput, part: int, depth: str
) -> NDArray[np.uint8 | np.uint16 | np.float32] | None:
    """Read all pixels of one part of an open file.

    For a truncated JPEG, OpenImageIO invents the missing pixels; only its error tells.

    Parameters
    ----------
    image : OpenImageIO.ImageInput
    part : int
    depth : {"uint8", "uint16", "float", ...}
        The type that values are converted to.

    Returns
    -------
    (H, W, n) array of that dtype or None
        The data window, or None if it cannot be read; ``image.geterror()`` then says why.
    """
    pixels = image.read_image(part, 0, 0, image.spec().nchannels, depth)
    return None if image.has_error else pixels


def reason_of(said: str) -> str:
    """The first line of OpenImageIO's error: the others give advice or repeat it."""
    return said.split("\n")[0].rstrip(".")
