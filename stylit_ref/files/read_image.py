"""Read images with OpenImageIO: PNG, TIFF, JPEG, (multilayer) EXR, ...

Files are read at their own depth or converted to 8 bits (:mod:`stylit_ref.files.colour.bit_depth`).
An alpha channel that is opaque everywhere is dropped, and so is one that is 0 everywhere, which
renderers and game tools leave empty. Otherwise colours are multiplied by it, so that averages of
transparent pixels come out right.
"""

import logging
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.colour.bit_depth import to_uint8_by_rows
from stylit_ref.files.picture import Picture, read_picture
from stylit_ref.notes import note


def read_image(path: str | Path) -> NDArray[np.uint8 | np.uint16 | np.float32]:
    """Read an image at its own depth.

    Parameters
    ----------
    path : str or Path
        A file. ``file:LAYER`` names a layer of a multilayer EXR, or a part or a view; the end of
        its name will do where it fits one alone. ``file:LAYER.A`` names a channel, and
        ``file:CryptoObject/NAME`` the matte of an object.

    Returns
    -------
    (H, W, n) uint8, uint16 or float32
        The display window; pixels outside the data window are 0.

    Raises
    ------
    InputError
        If the file or layer is missing, cannot be read, declares more than
        :data:`~stylit_ref.files.disk.image_file.LARGEST_IMAGE` values, or holds NaN or infinity.
    """
    return read_picture(path).pixels


def read_uint8(path: str | Path) -> NDArray[np.uint8]:
    """Read an image as 8-bit display values.

    Parameters and errors are those of :func:`read_image`.

    Returns
    -------
    (H, W, n) uint8
    """
    return displayed(path, read_picture(path))


def displayed(path: str | Path, picture: Picture) -> NDArray[np.uint8]:
    """The 8-bit display values of a picture that was read of ``path``.

    A note says how many values are clipped.

    Parameters
    ----------
    path : str or Path
        As the user wrote it.
    picture : Picture

    Returns
    -------
    (H, W, n) uint8
    """
    if picture.pixels.dtype == np.float32:
        clipped = np.mean((picture.colours < -0.01) | (picture.colours > 1.01))
        if clipped:
            share = f"{clipped:.0%}" if clipped >= 0.01 else "less than 1%"
            note(
                f"{path}: {share} of the values lie outside [0, 1] and are clipped",
                level=logging.WARNING if clipped > 0.05 else logging.INFO,
            )
    curve = "srgb" if picture.is_light else "none"
    return to_uint8_by_rows(picture.pixels, picture.alpha_channel, curve)


def read_mask(path: str | Path) -> NDArray[np.bool_]:
    """Read an image as a mask: what is white in it.

    Its values are data and go through no curve; the mean of its colours counts. Alpha is no colour:
    what is transparent shows as black.

    Parameters and errors are those of :func:`read_image`.

    Returns
    -------
    (H, W) bool
        Where the image is at least half as bright as it can be.
    """
    image, alpha_channel = read_picture(path)[:2]
    half = 0.5 if image.dtype == np.float32 else (np.iinfo(image.dtype).max + 1) // 2
    return image[:, :, :alpha_channel].mean(axis=2) >= half
