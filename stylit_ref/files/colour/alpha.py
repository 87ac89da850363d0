"""Integer colours and the alpha that they are multiplied by, or not."""

import numpy as np
from numpy.typing import NDArray

OURS_TO_MULTIPLY = ("bmp", "dds", "gif", "ico", "jpeg2000", "sgi", "targa")
"""Formats whose files hold colours without alpha, and for which OpenImageIO does not multiply them,
or does so by a power of alpha (JPEG 2000), or cuts off fractions (Targa)."""

OURS_TO_DIVIDE = (*OURS_TO_MULTIPLY, "webp")
"""The same when it writes."""


def multiplied_by_alpha(
    image: NDArray[np.uint8 | np.uint16],
) -> NDArray[np.uint8 | np.uint16]:
    """Multiply colours by alpha, the last channel.

    Parameters
    ----------
    image : (H, W, n) uint8 or uint16

    Returns
    -------
    array of the same shape and dtype
    """
    colours, alpha, largest = _parts(image)
    return _joined((colours * alpha + largest // 2) // largest, alpha, image.dtype)


def divided_by_alpha(image: NDArray[np.uint8 | np.uint16]) -> NDArray[np.uint8 | np.uint16]:
    """Divide colours by alpha, the last channel; where it is 0 they stay 0.

    Parameters
    ----------
    image : (H, W, n) uint8 or uint16

    Returns
    -------
    array of the same shape and dtype
    """
    colours, alpha, largest = _parts(image)
    straight = (colours * largest + alpha // 2) // np.maximum(alpha, 1)
    return _joined(np.minimum(straight, largest), alpha, image.dtype)


def _parts(image):
    wide = image.astype(np.uint64)
    return wide[:, :, :-1], wide[:, :, -1:], np.iinfo(image.dtype).max


def _joined(colours, alpha, dtype):
    return np.concatenate([colours, alpha], axis=2).astype(dtype)
