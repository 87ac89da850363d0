"""Read images with OpenImageIO: PNG, TIFF, JPEG, (multilayer) EXR, ...

Files are read at their own depth or converted to 8 bits (:mod:`stylit_ref.files.bit_depth`).
An alpha channel that is opaque everywhere is dropped, and so is one that is 0 everywhere, which
renderers and game tools leave empty. Otherwise OpenImageIO premultiplies the colours by it, so that
averages of transparent pixels come out right.
"""

import logging
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.bit_depth import to_uint8
from stylit_ref.files.cryptomatte import cryptomattes_of, find_matte, read_matte
from stylit_ref.files.layer_names import find_layer, split_layer
from stylit_ref.files.layer_pixels import read_layer
from stylit_ref.files.layers import contents_of
from stylit_ref.notes import note


class _Picture(NamedTuple):
    """What was read of a file.

    Attributes
    ----------
    pixels : (H, W, n) uint8, uint16 or float32
    alpha_channel : int or None
        The last, if there is one.
    is_light : bool
        Whether floating point is scene-linear light; otherwise it is data.
    """

    pixels: NDArray[np.uint8 | np.uint16 | np.float32]
    alpha_channel: int | None
    is_light: bool


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
        :data:`~stylit_ref.files.image_file.LARGEST_IMAGE` values, or holds NaN or infinity.
    """
    return _read(path)[0]


def read_uint8(path: str | Path) -> NDArray[np.uint8]:
    """Read an image as 8-bit display values.

    Parameters and errors are those of :func:`read_image`.

    Returns
    -------
    (H, W, n) uint8
    """
    return _displayed(path)[0]


def read_guides(
    source_path: str | Path, target_path: str | Path
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Read a guide of the source and of the target so that their channels agree.

    Alpha is dropped if it is opaque in both images and otherwise kept, or added, in
    both; a grey image beside one in colour is spread to three channels.

    Parameters and errors are those of :func:`read_image`.

    Returns
    -------
    source, target : (H, W, n) uint8
        Their numbers of channels still differ if neither image is grey and the files differ.
    """
    read = list(map(_displayed, (source_path, target_path)))
    transparent = any(alpha is not None for _, alpha in read)
    colours = max(guide.shape[2] - (alpha is not None) for guide, alpha in read)
    guides = []
    for guide, alpha in read:
        if guide.shape[2] - (alpha is not None) == 1:
            guide = np.concatenate([guide[:, :, :1]] * colours + [guide[:, :, 1:]], axis=2)
        if transparent and alpha is None:
            opaque = np.full((*guide.shape[:2], 1), 255, np.uint8)
            guide = np.concatenate([guide, opaque], axis=2)
        guides.append(guide)
    return tuple(guides)


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
    image, alpha_channel, _ = _read(path)
    half = 0.5 if image.dtype == np.float32 else (np.iinfo(image.dtype).max + 1) // 2
    return image[:, :, :alpha_channel].mean(axis=2) >= half


def _read(path):
    """Read a file, a layer, a channel or a matte, without an alpha that tells nothing."""
    file, name = split_layer(path)
    contents = contents_of(file)
    matte = find_matte(file, name, cryptomattes_of(contents))
    if matte:
        return _Picture(read_matte(path, file, *matte), None, is_light=False)
    layer = find_layer(file, name, contents)
    if contents.has_frames:
        note(f"{path}: holds several images; the first is read")
    pixels, alpha_channel = read_layer(path, file, layer), layer.alpha_channel
    if alpha_channel is not None:
        alpha = pixels[:, :, alpha_channel]
        opaque = 1 if alpha.dtype == np.float32 else np.iinfo(alpha.dtype).max
        if (alpha <= 0).all():
            note(f"{path}: is transparent everywhere; its alpha is left out", level=logging.WARNING)
            pixels = read_layer(path, file, layer, straight=True)
        if (alpha <= 0).all() or (alpha >= opaque).all():
            pixels, alpha_channel = np.ascontiguousarray(pixels[:, :, :alpha_channel]), None
    if layer.roles[:3] == ("Y", "RY", "BY"):
        pixels = _colours_of_luminance(pixels)
    return _Picture(pixels, alpha_channel, layer.is_light)


def _colours_of_luminance(pixels):
    """Colours of luminance Y and (R - Y) / Y, (B - Y) / Y, for the primaries of sRGB."""
    luminance = pixels[:, :, 0]
    red, blue = luminance * (pixels[:, :, 1] + 1), luminance * (pixels[:, :, 2] + 1)
    green = (luminance - 0.2126 * red - 0.0722 * blue) / 0.7152
    return np.dstack([red, green, blue, pixels[:, :, 3:]])


def _displayed(path):
    """8-bit display values of a file or layer, and the index of their alpha channel or None.

    Warns if the conversion clips more than a few highlights.
    """
    image, alpha_channel, is_light = _read(path)
    if image.dtype == np.float32:
        colours = image[:, :, :alpha_channel]
        clipped = np.mean((colours < -0.01) | (colours > 1))
        if clipped > 0.05:
            note(
                f"{path}: {clipped:.0%} of the values lie outside [0, 1] and are clipped",
                level=logging.WARNING,
            )
    curve = "srgb" if is_light else "none"
    # Row by row, since a conversion takes much memory.
    rows = [to_uint8(row, alpha_channel, curve=curve) for row in image]
    return np.stack(rows), alpha_channel
