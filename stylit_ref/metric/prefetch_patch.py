"""Ask for the pixels of a patch before they are read. Changes no result."""

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.prefetch import prefetch

_LINE = 64  # bytes

NEAR = 4 << 20
"""Bytes of a texture from which patches are fetched ahead; smaller ones stay in a cache."""


@lru_cache
def make_prefetch_patch(patch_width: int, channels: int) -> Callable[..., None]:
    """Compile for patches of this size.

    Returns
    -------
    callable
        ``(texture, first_y, first_x)``: fetch the cache lines of the patch whose first pixel this
        is, of an (H, W, channels) uint8 texture.
    """
    row = patch_width * channels

    @inlined
    def prefetch_patch(texture, first_y, first_x):
        for dy in range(patch_width):
            place = ((first_y + dy) * np.int64(texture.shape[1]) + first_x) * channels
            for byte in range(0, row, _LINE):
                prefetch(texture, place + byte)
            prefetch(texture, place + row - 1)

    return prefetch_patch
