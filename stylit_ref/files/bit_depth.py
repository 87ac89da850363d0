"""Convert between the 8-bit display values of the synthesis and deeper images.

16-bit integers become ``round(v / 257)``. Floating point is taken as scene-linear
light, clipped to [0, 1] and encoded by the sRGB transfer curve; alpha stays linear.
"""

import logging
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from skimage.util import img_as_float32

from stylit_ref.errors import InputError
from stylit_ref.notes import note

Curve = Literal["srgb", "none"]


def to_uint8(
    image: NDArray[np.uint8 | np.uint16 | np.floating],
    alpha_channel: int | None = None,
    *,
    curve: Curve | None = None,
) -> NDArray[np.uint8]:
    """Convert an image to 8 bits as displayed.

    Parameters
    ----------
    image : (H, W, ...) uint8, uint16 or floating point
        Floating point is clipped to [0, 1].
    alpha_channel : int, optional
        Channel that is not light and stays linear.
    curve : {"srgb", "none"}, optional
        What floating point goes through; integers are display values already. ``"srgb"`` is for
        scene-linear light, as EXR files hold it. ``"none"`` is for display values between 0 and 1,
        as ``image / 255`` and scikit-image have them. By default ``"srgb"``, with a note.

    Returns
    -------
    array of the same shape, uint8

    Raises
    ------
    InputError
        If the dtype or the curve is another one.
    """
    if curve not in (None, "srgb", "none"):
        raise InputError(f"is {curve!r}; it must be 'srgb' or 'none'", parameter="curve")
    image = np.asarray(image)
    if image.dtype == np.uint8:
        return image
    if image.dtype == np.uint16:
        return ((image.astype(np.uint32) + 128) // 257).astype(np.uint8)
    if not np.issubdtype(image.dtype, np.floating):
        raise InputError(
            f"has dtype {image.dtype}; it must be uint8, uint16 or float", parameter="image"
        )
    if curve is None:
        note(
            "is floating point and taken as scene-linear light, which makes it brighter; "
            "curve='none' takes display values such as image / 255 as they are, and curve='srgb' "
            "says that it is light",
            parameter="image",
            level=logging.WARNING,
        )
    displayed = _clipped(image) if curve == "none" else _encoded(image, alpha_channel)
    return np.floor(displayed * 255 + 0.5).astype(np.uint8)


def to_depth(
    image: NDArray[np.uint8 | np.uint16 | np.float32], dtype: np.dtype
) -> NDArray[np.uint8 | np.uint16 | np.float32]:
    """Convert an image to the depth of another one: uint8, uint16, or float32 of linear light.

    With 2 or 4 channels the last is alpha.
    """
    alpha_channel = -1 if image.ndim == 3 and image.shape[2] in (2, 4) else None
    if image.dtype == dtype:
        return image
    if dtype == np.float32:
        return to_linear(image)
    if dtype == np.uint8:
        return to_uint8(image, alpha_channel, curve="srgb")
    if image.dtype == np.uint8:
        return image.astype(np.uint16) * np.uint16(257)
    return np.floor(_encoded(image, alpha_channel) * 65535 + 0.5).astype(np.uint16)


def _clipped(image):
    return np.clip(image.astype(np.float32), 0, 1)


def _encoded(image, alpha_channel):
    """Display values of scene-linear light, between 0 and 1."""
    linear = _clipped(image)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    if alpha_channel is not None:
        encoded[..., alpha_channel] = linear[..., alpha_channel]
    return encoded


def to_linear(image: NDArray[np.uint8 | np.uint16 | np.floating]) -> NDArray[np.float32]:
    """Invert the sRGB curve: turn displayed integers into float32 scene-linear light."""
    encoded = img_as_float32(image)
    linear = np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
    if image.ndim == 3 and image.shape[2] in (2, 4):
        linear[..., -1] = encoded[..., -1]
    return linear.astype(np.float32)
