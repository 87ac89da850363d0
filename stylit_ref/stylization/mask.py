"""Target pixels that are left alone.

The patches within a radius of a pixel vote for it. They read style pixels within another radius,
each of which is again covered by one of them. So the patches that touch an unmasked pixel form a
closed system: only they are assigned and counted in Ω, and the result has no seam at the edge of
the mask.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray


def active_patches(mask: NDArray[np.bool_], patch_width: int) -> NDArray[np.bool_]:
    """Target patches that take part: all that touch an unmasked pixel.

    Parameters
    ----------
    mask : (H, W) bool
        True where the target is left alone.
    patch_width : int

    Returns
    -------
    (H, W) bool
    """
    if not mask.any():
        return ~mask
    # Imported late: it takes a third of the start-up time.
    from skimage.morphology import dilation, footprint_rectangle

    return dilation(~mask, footprint_rectangle((patch_width, patch_width)))


def downsample_mask(synthesized: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Halve a map of synthesized pixels: a pixel is synthesized if any of its finer pixels is.

    Parameters
    ----------
    synthesized : (H, W) bool

    Returns
    -------
    (H // 2, W // 2) bool
    """
    rows, columns = (np.arange(0, size - 1, 2) for size in synthesized.shape)
    return np.logical_or.reduceat(
        np.logical_or.reduceat(synthesized, rows, axis=0), columns, axis=1
    )


def fill_masked(
    image: NDArray[np.uint8], mask: NDArray[np.bool_], fill: ArrayLike | None
) -> NDArray[np.uint8]:
    """Put ``fill`` into the masked pixels, or make them transparent.

    Parameters
    ----------
    image : (H, W, n) uint8
        1 to 4 channels; with 2 or 4 the last is alpha.
    mask : (H, W) bool
    fill : (H, W) or (H, W, n) uint8, or None

    Returns
    -------
    (H, W, n) uint8, or (H, W, n + 1) where an alpha channel was added
    """
    if fill is not None:
        filled = image.copy()
        filled[mask] = np.reshape(fill, image.shape)[mask]
        return filled
    if image.shape[2] % 2:
        opaque = np.full((*image.shape[:2], 1), 255, np.uint8)
        filled = np.concatenate([image, opaque], axis=2)
    else:
        filled = image.copy()
    filled[mask] = 0
    return filled
