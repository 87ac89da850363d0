"""Put a caller's pixels into an image with a border."""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.vector_pixel import make_spread_pixel
from stylit_ref.realtime.passes.border import extend_row
from stylit_ref.realtime.passes.image import Image


@inlined
def _put_pixel(pixels, start, values, to, channels):
    for c in range(channels):
        values[to + c] = pixels[start + c]


@cache
def make_fill(channels: int, lanes: int) -> Callable[..., None]:
    """Build ``fill(pixels, image)``: flat pixels of ``channels`` bytes into those of ``lanes``."""
    spread_pixel = make_spread_pixel(channels, lanes)

    @kernel(channels, lanes, nogil=True)
    def fill(pixels: NDArray[np.uint8], image: Image) -> None:
        for row in prange(image.height):
            y = np.int64(row)
            start = ((y + image.border) * image.stride + image.border) * lanes
            read = y * image.width * channels
            whole = min(image.width, (pixels.size - lanes - read) // channels + 1)
            for x in range(whole):
                spread_pixel(image.values, start + x * lanes, pixels, read + x * channels)
            for x in range(max(whole, 0), image.width):  # the last, after which nothing may be read
                _put_pixel(pixels, read + x * channels, image.values, start + x * lanes, channels)
            extend_row(image, y, np.int64(lanes))

    return fill
