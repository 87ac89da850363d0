"""Put a caller's pixels into an image with a border."""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.realtime.passes.border import extend_row
from stylit_ref.realtime.passes.image import Image


@inlined
def _fill_row(pixels, line, width, channels, lanes):
    for x in range(np.uint64(width)):
        for c in range(np.uint64(channels)):
            line[x * np.uint64(lanes) + c] = pixels[x, c]


@cache
def make_fill(channels: int, lanes: int) -> Callable[..., None]:
    """Build ``fill(pixels, image)``: (height, width, channels) into pixels of ``lanes`` bytes."""

    @kernel(channels, lanes, nogil=True)
    def fill(pixels: NDArray[np.uint8], image: Image) -> None:
        for row in prange(image.height):
            y = np.int64(row)
            start = ((y + image.border) * image.stride + image.border) * lanes
            line = image.values[start : start + image.width * lanes]
            _fill_row(pixels[y], line, image.width, channels, lanes)
            extend_row(image, y, lanes)

    return fill
