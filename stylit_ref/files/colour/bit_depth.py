"""Convert between the 8-bit display values of the synthesis and deeper images.

16-bit integers become ``round(v / 257)``. Floating point is scene-linear light, clipped to [0, 1]
and encoded by the sRGB transfer curve, or data, which needs no curve.

Colours are premultiplied by alpha, while the curve belongs on those of the paint itself. So it goes
over colours divided by alpha, which are multiplied by alpha again. Alpha is data.
"""

import logging
from collections.abc import Callable
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
        Colours are premultiplied by alpha. Floating point is clipped to [0, 1].
    alpha_channel : int, optional
        Channel of the last axis that is alpha.
    curve : {"srgb", "none"}, optional
        What floating point goes through; integers are display values already. ``"srgb"`` is for
        scene-linear light, as EXR files hold it. ``"none"`` is for data, and for display values
        between 0 and 1, as ``image / 255`` and scikit-image have them. By default ``"srgb"``, with
        a note.

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
    shown = image.astype(np.float32)
    if curve != "none":
        shown = _over_straight_colours(_encode, shown, alpha_channel)
    return _rounded(shown, 255).astype(np.uint8)


def to_uint8_by_rows(
    image: NDArray[np.uint8 | np.uint16 | np.floating], alpha_channel: int | None, curve: Curve
) -> NDArray[np.uint8]:
    """As :func:`to_uint8`, row by row, since a conversion takes much memory."""
    return np.stack([to_uint8(row, alpha_channel, curve=curve) for row in image])


def to_depth(
    image: NDArray[np.uint8 | np.uint16 | np.float32], dtype: np.dtype
) -> NDArray[np.uint8 | np.uint16 | np.float32]:
    """Convert an image to the depth of another one: uint8, uint16, or float32 of linear light.

    With 2 or 4 channels the last is alpha.
    """
    alpha_channel = image.shape[2] - 1 if image.ndim == 3 and image.shape[2] in (2, 4) else None
    if image.dtype == dtype:
        return image
    if dtype == np.float32:
        return to_linear(image, alpha_channel)
    if dtype == np.uint8:
        return to_uint8(image, alpha_channel, curve="srgb")
    if image.dtype == np.uint8:
        return image.astype(np.uint16) * np.uint16(257)
    shown = _over_straight_colours(_encode, image, alpha_channel)
    return _rounded(shown, 65535).astype(np.uint16)


def _rounded(shown, largest):
    return np.floor(np.clip(shown, 0, 1) * largest + 0.5)


def to_linear(
    image: NDArray[np.uint8 | np.uint16 | np.floating], alpha_channel: int | None = None
) -> NDArray[np.float32]:
    """Invert the sRGB curve: turn displayed values into scene-linear light.

    Parameters
    ----------
    image : (H, W, ...) uint8, uint16 or floating point
        Displayed values; colours are premultiplied by alpha.
    alpha_channel : int, optional
        Channel of the last axis that is alpha.

    Returns
    -------
    array of the same shape, float32
        Colours are premultiplied by alpha again.
    """
    return _over_straight_colours(_decode, img_as_float32(image), alpha_channel)


def _encode(linear):
    linear = np.maximum(linear, 0)
    curve = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.where(linear == 1, 1, curve)  # it gives a little less, and half of it rounds down


def _decode(encoded):
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


def _over_straight_colours(
    curve: Callable[[NDArray[np.float32]], NDArray[np.float32]],
    image: NDArray[np.float32],
    alpha_channel: int | None,
) -> NDArray[np.float32]:
    """Put a curve over colours divided by alpha, and multiply them by alpha again.

    Where alpha is 0, colours are light without a surface, and the curve goes over them as they are.
    """
    with np.errstate(over="ignore"):  # infinity is clipped as other large values are
        if alpha_channel is None:
            return curve(image)
        alpha = np.clip(image[..., alpha_channel], 0, 1)
        divisor = np.where(alpha > 0, alpha, 1)[..., np.newaxis]
        curved = curve(image / divisor) * divisor
    curved[..., alpha_channel] = alpha
    return curved
