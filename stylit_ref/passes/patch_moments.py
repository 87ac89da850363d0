"""Moments of every patch, for the lower bound of δ."""

from functools import lru_cache

import numpy as np
from numba import get_num_threads, prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.metric.lower_bound import LINE_MOMENTS, POLYNOMIALS, moment_width


@lru_cache
def _make_kernel(patch_width, channels, style_channel, style_channels):
    """Compile for constant widths and channels, so that the innermost loops are vectorized."""
    width = moment_width(patch_width)
    margin = patch_width // 2 - width // 2
    _, slope, curve = POLYNOMIALS[width]

    @kernel(patch_width, channels, style_channel, style_channels)
    def patch_moments_kernel(texture, moments, first, first_channel, columns):
        rows = texture.shape[0] - patch_width + 1
        bands = columns.shape[0]
        for band in prange(bands):
            # Apply each polynomial down the columns first, then along the row.
            sums, slopes, curves = columns[band, 0], columns[band, 1], columns[band, 2]
            for y in range(rows * band // bands, rows * (band + 1) // bands):
                for x in range(texture.shape[1]):
                    for c in range(first_channel, channels):
                        total = np.int16(0)
                        for dy in range(width):
                            total += texture[y + margin + dy, x, c]
                        sums[x, c] = total
                    for s in range(style_channels):
                        along_y = along_yy = np.int16(0)
                        for dy in range(width):
                            value = np.int16(texture[y + margin + dy, x, style_channel + s])
                            along_y += slope[dy] * value
                            along_yy += curve[dy] * value
                        slopes[x, s] = along_y
                        curves[x, s] = along_yy
                for x in range(texture.shape[1] - patch_width + 1):
                    own = moments[first + y, first + x]
                    for c in range(first_channel, channels):
                        total = np.int16(0)
                        for dx in range(width):
                            total += sums[x + margin + dx, c]
                        own[c] = total
                    for s in range(style_channels):
                        along_x = along_y = along_xx = along_yy = along_xy = 0
                        for dx in range(width):
                            near_x = x + margin + dx
                            total = sums[near_x, style_channel + s]
                            along_x += slope[dx] * total
                            along_xx += curve[dx] * total
                            along_y += slopes[near_x, s]
                            along_xy += slope[dx] * slopes[near_x, s]
                            along_yy += curves[near_x, s]
                        place = channels + 2 * s
                        own[place], own[place + 1] = along_x, along_y
                        place += 2 * style_channels
                        own[place], own[place + 1] = along_xx, along_yy
                        own[channels + 4 * style_channels + s] = along_xy

    return patch_moments_kernel


def patch_moments(
    texture: NDArray[np.uint8],
    moments: NDArray[np.int16],
    patch_width: int,
    first: int,
    style_channel: int,
    style_channels: int,
    style_only: bool = False,
) -> None:
    """Compute the moments of every patch that lies in a texture.

    Parameters
    ----------
    texture : (H, W, C) uint8
    moments : (H', W', lanes) int16
        ``moments[first + y, first + x]`` receives the moments of the patch whose first pixel is
        ``texture[y, x]`` (of its central 5 x 5 pixels if it is wider), in the order of
        :attr:`stylit_ref.metric.packing.Packing.moments`. ``first`` is ``radius`` for the source,
        whose moments are indexed by patch centre, and 0 for the target, whose edge is repeated
        ``radius`` times.
    patch_width, first : int
    style_channel, style_channels : int
        First style channel in a packed pixel and their number.
    style_only : bool
        Leave the sums of guides in front of the style as they are; votes do not change them.
    """
    run = _make_kernel(patch_width, texture.shape[2], style_channel, style_channels)
    columns = np.empty((get_num_threads(), 3, *texture.shape[1:]), np.int16)
    run(texture, moments, first, style_channel if style_only else 0, columns)


def moments_storage(height: int, width: int, lanes: int) -> NDArray[np.int16]:
    """Zeros for the moments of all patches; the array begins at the start of a cache line.

    Parameters
    ----------
    height, width, lanes : int

    Returns
    -------
    (height, width, lanes) int16
    """
    size = height * width * lanes
    buffer = np.zeros(size + LINE_MOMENTS, np.int16)
    first = -(buffer.ctypes.data // 2) % LINE_MOMENTS
    return buffer[first : first + size].reshape(height, width, lanes)
