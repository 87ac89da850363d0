"""The limited search among the shifted NNFs (3.3.2)."""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.vector_patch import (
    STYLE_LANES,
    alike_in_pairs,
    make_patch_ssd,
    make_widen,
    row_lanes,
)
from stylit_ref.realtime.formulae.packed_nnf import column_of, row_of
from stylit_ref.realtime.passes.image import Image


@cache
def make_limited_search(width: int) -> Callable[..., None]:
    """Build ``limited_search`` for patches of ``width`` x ``width`` pixels.

    Each pixel takes the patch that differs least from the picture around it, in style alone: the
    chosen one, or one of the candidates if it is strictly better, in their order. The pass is
    called with

    - ``nnf``, (H, W) int32: packed entries, whose patches lie within the style;
    - ``candidates``, (K, H, W) int32, -1 where they are masked;
    - ``style`` and ``picture``, images of 4 bytes a pixel, whose border repeats the edge;
    - ``weights``, int16, of a row of a patch;
    - ``found``, (H, W) int32, which is written.
    """
    radius, length = width // 2, row_lanes(width, STYLE_LANES)
    widen = make_widen(width, width, STYLE_LANES)
    ssd = make_patch_ssd(width, length)

    @kernel(width, nogil=True)
    def limited_search(
        nnf: NDArray[np.int32],
        candidates: NDArray[np.int32],
        style: Image,
        picture: Image,
        weights: NDArray[np.int16],
        found: NDArray[np.int32],
    ) -> None:
        stride = style.stride * STYLE_LANES
        origin = (style.border - radius) * (style.stride + 1) * STYLE_LANES
        picture_origin = (picture.border - radius) * (picture.stride + 1)
        picture_stride = picture.stride * STYLE_LANES
        alike = alike_in_pairs(weights)
        for row in prange(nnf.shape[0]):
            y = np.int64(row)
            patch = np.empty(width * length, np.int16)
            for x in range(nnf.shape[1]):
                best_entry = nnf[np.uint64(y), np.uint64(x)]
                best = np.int64(-1)  # not known: most pixels have one candidate alone
                for k in range(candidates.shape[0]):
                    entry = candidates[np.uint64(k), np.uint64(y), np.uint64(x)]
                    if entry < 0 or entry == best_entry:
                        continue
                    if best < 0:
                        at = (picture_origin + y * picture.stride + x) * STYLE_LANES
                        widen(
                            patch, picture.values, at, picture_stride,
                            picture.values, at, picture_stride,
                        )  # fmt: skip
                        at = origin + row_of(best_entry) * stride
                        at += column_of(best_entry) * STYLE_LANES
                        best = np.int64(ssd(style.values, at, stride, patch, 0, weights, alike))
                    at = origin + row_of(entry) * stride + column_of(entry) * STYLE_LANES
                    error = np.int64(ssd(style.values, at, stride, patch, 0, weights, alike))
                    if error < best:
                        best, best_entry = error, entry
                found[np.uint64(y), np.uint64(x)] = best_entry

    return limited_search
