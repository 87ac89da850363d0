"""Convert between the 8-bit display values of the synthesis and deeper images.

16-bit integers become ``round(v / 257)``. Floating point is scene-linear light, clipped to [0, 1]
and encoded by the sRGB transfer curve, or data, which needs no curve.

Colours are premultiplied by alpha, while the curve belongs on those of the paint itself. So it goes
over colours divided by alpha, which are multiplied by alpha again. Alpha is data.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from skimage.util import img_as_float32

from stylit_ref.errors import InputError


def to_uint8(
    image: NDArray[np.uint8 | np.uint16 | np.floating],
    alpha_channel: int | None = None,
    *,
    is_light: bool = True,
) -> NDArray[np.uint8]:
    """Convert an image to 8 bits as displayed.

    Parameters
    ----------
    image : (H, W, ...) uint8, uint16 or floating point
        Colours are premultiplied by alpha.
    alpha_channel : int, optional
        Channel of the last axis that is alpha.
    is_light : bool
        Whether floating point is scene-linear light, which goes through the sRGB curve. Otherwise
        1 becomes 255 without a curve.

    Returns
    -------
    array of the same shape, uint8

    Raises
    ------
    InputError
        If the dtype is another one.
    """
    image = np.asarray(image)
    if image.dtype == np.uint8:
        return image
    if image.dtype == np.uint16:
        return ((image.astype(np.uint32) + 128) // 257).astype(np.uint8)
    if not np.issubdtype(image.dtype, np.floating):
        raise InputError(
            f"has dtype {image.dtype}; it must be uint8, uint16 or float", parameter="image"
        )
    shown = image.astype(np.float32)
    if is_light:
        shown = _over_straight_colours(_encode, shown, alpha_channel)
    return np.floor(np.clip(shown, 0, 1) * 255 + 0.5).astype(np.uint8)


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
