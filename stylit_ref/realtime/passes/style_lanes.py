"""Put the style beside the guides of the source, where a candidate is read in one piece."""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import prange

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.realtime.passes.image import Image


@inlined
def _insert_row(style, source, pixels, lanes):
    for x in range(np.uint64(pixels)):
        for c in range(np.uint64(STYLE_LANES)):
            at = np.uint64(lanes) * x + np.uint64(lanes - STYLE_LANES) + c
            source[at] = style[np.uint64(STYLE_LANES) * x + c]


@cache
def make_insert_style(lanes: int) -> Callable[..., None]:
    """Build ``insert_style(style, source, top, bottom)`` for pixels of ``lanes`` bytes.

    It writes the last four bytes of every pixel in rows ``[top, bottom)``, which count the border.
    """

    @kernel(lanes, nogil=True)
    def insert_style(style: Image, source: Image, top: int, bottom: int) -> None:
        for k in prange(bottom - top):
            start = (top + np.int64(k)) * style.stride
            end = start + style.stride
            painted = style.values[start * STYLE_LANES : end * STYLE_LANES]
            _insert_row(painted, source.values[start * lanes : end * lanes], style.stride, lanes)

    return insert_style
