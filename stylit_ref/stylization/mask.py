"""Target pixels that are left alone.

The patches within a radius of a pixel vote for it. They read style pixels within another radius,
each of which is again covered by one of them. So the patches that touch an unmasked pixel form a
closed system: only they are assigned and counted in Ω, and the result has no seam at the edge of
the mask.
"""

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Value = TypeVar("Value", bound=np.uint8 | np.uint16 | np.float32)


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


def wholly_assigned(assigned: NDArray[np.bool_], patch_width: int) -> NDArray[np.bool_]:
    """Pixels of which every patch that covers them is assigned.

    Of the patches of :func:`active_patches` these are the unmasked pixels, and those masked ones
    that lie in gaps narrower than a patch.

    Parameters
    ----------
    assigned : (H, W) bool
        Target patches that have a source patch.
    patch_width : int

    Returns
    -------
    (H, W) bool
    """
    if assigned.all():
        return assigned
    from skimage.morphology import erosion, footprint_rectangle

    return erosion(assigned, footprint_rectangle((patch_width, patch_width)))


def fill_masked(
    image: NDArray[Value], mask: NDArray[np.bool_], fill: NDArray[Value] | None
) -> NDArray[Value]:
    """Put ``fill`` into the masked pixels, or make them transparent.

    A grey image beside one in colour is spread to its channels; an alpha channel of one is given
    to the other.

    Parameters
    ----------
    image : (H, W, n) uint8, uint16 or float32
        With an even number of channels the last is alpha.
    mask : (H, W) bool
    fill : (H, W) or (H, W, m) of the same dtype, or None

    Returns
    -------
    (H, W, n) of the same dtype
        With :func:`filled_channels` channels.
    """
    if fill is None:
        fill = np.zeros((*mask.shape, filled_channels(image.shape[2], None)), image.dtype)
    fill = fill if fill.ndim == 3 else fill[:, :, None]
    channels = filled_channels(image.shape[2], fill.shape[2])
    filled = _with_channels(image, channels)
    filled[mask] = _with_channels(fill, channels)[mask]
    return filled


def filled_channels(image_channels: int, fill_channels: int | None) -> int:
    """Number of channels of :func:`fill_masked`: colours of either, and alpha if one has it.

    Without a fill (None) there is alpha.
    """
    every = image_channels, image_channels if fill_channels is None else fill_channels
    colours = max(_colours(channels) for channels in every)
    transparent = fill_channels is None or any(channels % 2 == 0 for channels in every)
    return colours + transparent


def _colours(channels):
    return channels - 1 + channels % 2


def _with_channels(image, channels):
    """A copy of the image with its grey spread and an opaque alpha added, as far as needed."""
    colours = _colours(image.shape[2])
    colour, alpha = image[:, :, :colours], image[:, :, colours:]
    if colours == 1:
        colour = colour.repeat(_colours(channels), axis=2)
    if channels % 2 == 0 and not alpha.size:
        opaque = 1 if image.dtype == np.float32 else np.iinfo(image.dtype).max
        alpha = np.full((*image.shape[:2], 1), opaque, image.dtype)
    return np.concatenate([colour, alpha], axis=2)
