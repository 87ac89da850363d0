"""Convert between the 8-bit display values of the synthesis and deeper images.

16-bit integers become ``round(v / 257)``. Floating point is taken as scene-linear
light, clipped to [0, 1] and encoded by the sRGB transfer curve; alpha stays linear.
"""

import numpy as np
from numpy.typing import NDArray
from skimage.util import img_as_float32

from stylit_ref.errors import InputError


def to_uint8(
    image: NDArray[np.uint8 | np.uint16 | np.floating], alpha_channel: int | None = None
) -> NDArray[np.uint8]:
    """Convert an image to 8 bits as displayed.

    Parameters
    ----------
    image : (H, W, ...) uint8, uint16 or floating point
        Floating point is scene-linear light.
    alpha_channel : int, optional
        Channel that is not light and stays linear.

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
    linear = np.clip(image.astype(np.float32), 0, 1)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    if alpha_channel is not None:
        encoded[..., alpha_channel] = linear[..., alpha_channel]
    return np.floor(encoded * 255 + 0.5).astype(np.uint8)


def to_linear(image: NDArray[np.uint8 | np.uint16 | np.floating]) -> NDArray[np.float32]:
    """Invert the sRGB curve: turn displayed integers into float32 scene-linear light."""
    encoded = img_as_float32(image)
    linear = np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
    if image.ndim == 3 and image.shape[2] in (2, 4):
        linear[..., -1] = encoded[..., -1]
    return linear.astype(np.float32)
