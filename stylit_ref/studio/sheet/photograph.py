"""A scan or photograph as upright RGB, however it was stored."""

from io import BytesIO
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageOps

from stylit_ref.errors import InputError

LARGEST = 100_000_000
"""Most pixels of a photograph; a file of a few bytes can declare any number."""

_SIXTEEN_BITS = "I;16", "I;16L", "I;16B", "I;16N"


def read_photograph(file: str | Path | bytes) -> NDArray[np.uint8]:
    """Read a photograph.

    It is turned as its EXIF orientation says. Grey and CMYK become RGB, and what is transparent
    shows white paper.

    Parameters
    ----------
    file : str, Path or bytes
        A file, or what it holds.

    Returns
    -------
    (H, W, 3) uint8

    Raises
    ------
    InputError
        If it cannot be read, or has more than :data:`LARGEST` pixels.
    """
    name = "the photograph" if isinstance(file, bytes) else str(file)
    try:
        with Image.open(BytesIO(file) if isinstance(file, bytes) else file) as image:
            width, height = image.size
            if width * height > LARGEST:
                raise InputError(
                    f"{name}: has {width}x{height} pixels; make it smaller, at most "
                    f"{LARGEST // 10**6} million pixels are read"
                )
            return np.asarray(_rgb(ImageOps.exif_transpose(image), name))
    except (Image.DecompressionBombError, Image.DecompressionBombWarning):
        raise InputError(
            f"{name}: has too many pixels; make it smaller, at most {LARGEST // 10**6} million are "
            "read"
        ) from None
    except Image.UnidentifiedImageError:
        raise InputError(
            f"{name}: is no image of a kind that can be read; save it as .jpg, .png or .tif"
        ) from None
    except (OSError, SyntaxError, ValueError) as error:  # Pillow raises each for damaged files
        if isinstance(error, InputError):
            raise
        raise InputError(
            f"{name}: cannot be read ({error}); save it again as .jpg or .png"
        ) from None


def _rgb(image, name):
    if image.mode in _SIXTEEN_BITS:
        return Image.fromarray((np.asarray(image) >> 8).astype(np.uint8)).convert("RGB")
    if image.mode in ("I", "F"):
        raise InputError(f"{name}: has more than 8 bits a channel; save it with 8 bits")
    if image.has_transparency_data:
        image = image.convert("RGBA")
        return Image.alpha_composite(Image.new("RGBA", image.size, "white"), image).convert("RGB")
    return image.convert("RGB")
