"""Open an image file and read its pixels."""

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import OpenImageIO as oiio
from numpy.typing import NDArray

from stylit_ref.errors import InputError

LARGEST_IMAGE = 1 << 29
"""Most values (pixels times channels) that are read of a file: 16384x8192 with 4 channels.

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
        said = _said(oiio.geterror)
        if "Subsampled channels" in said:
            raise InputError(
                f"{file}: stores luminance, and colour at a lower resolution; open it in an image "
                "editor and save it with R, G and B channels"
            )
        if "could not find a format reader" in said:
            raise InputError(
                f"{file}: is no image of a kind that can be read; save it as .png, .tif or .exr"
            )
        raise InputError(f"{file}: cannot be read: {_first_line(said)}")
    return image


def check_size(file: str | Path, spec: oiio.ImageSpec, channels: int) -> None:
    """Refuse an image whose header declares too large a data window or display window.

    Parameters
    ----------
    file : str or Path
    spec : OpenImageIO.ImageSpec
    channels : int
        How many channels are to be read.

    Raises
    ------
    InputError
        If either has more than :data:`LARGEST_IMAGE` values.
    """
    for width, height in ((spec.width, spec.height), (spec.full_width, spec.full_height)):
        if width * height * channels > LARGEST_IMAGE:
            raise InputError(
                f"{file}: declares {width}x{height} pixels with {channels} channels; at most "
                f"{LARGEST_IMAGE} values (width x height x channels) can be read; make it smaller"
            )


def read_pixels(
    image: oiio.ImageInput, part: int, numbers: Sequence[int], depth: str
) -> NDArray[np.uint8 | np.uint16 | np.float32] | None:
    """Read channels of one part of an open file.

    For a truncated JPEG, OpenImageIO invents the missing pixels; only its error tells.

    Parameters
    ----------
    image : OpenImageIO.ImageInput
    part : int
    numbers : sequence of int
        Numbers of the channels, in the order wanted. No other channel takes memory.
    depth : {"uint8", "uint16", "float", ...}
        The type that values are converted to.

    Returns
    -------
    (H, W, n) array of that dtype or None
        The data window, or None if it cannot be read; ``image.geterror()`` then says why.
    """
    ordered = sorted(numbers)
    begins = [number for number in ordered if number - 1 not in numbers]
    ends = [number + 1 for number in ordered if number + 1 not in numbers]
    read = [image.read_image(part, 0, *run, depth) for run in zip(begins, ends, strict=True)]
    if image.has_error:
        return None
    pixels = read[0] if len(read) == 1 else np.concatenate(read, axis=2)
    if ordered == list(numbers):
        return pixels
    return np.take(pixels, [ordered.index(number) for number in numbers], axis=2)


def reason_of(*geterror: Callable[[], str]) -> str:
    """What the first of OpenImageIO's ``geterror`` functions that knows an error says of it."""
    return _first_line(next(filter(None, map(_said, geterror)), "OpenImageIO gives no reason"))


def _said(geterror):
    try:
        return geterror()
    except UnicodeDecodeError:  # it quotes the file
        return "a name in its header is not UTF-8"


def _first_line(said):
    """The other lines give advice or repeat it."""
    return said.split("\n")[0].rstrip(".")
