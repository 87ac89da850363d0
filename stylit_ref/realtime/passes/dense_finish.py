"""A finish with a match for every pixel: the best of those of the sparse grid, then a vote."""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.vector_patch import (
    STYLE_LANES,
    alike_in_pairs,
    make_patch_ssd,
    make_widen,
    row_lanes,
)
from stylit_ref.realtime.formulae.average import mean_of
from stylit_ref.realtime.formulae.grid import covering_entries, first_centre, last_centre
from stylit_ref.realtime.formulae.packed_nnf import column_of, packed, row_of
from stylit_ref.realtime.passes.image import Image


@inlined
def _forbids(labels, source_labels, y, x, source_y, source_x):
    return (
        labels.size > 0
        and source_labels[np.uint64(source_y), np.uint64(source_x)]
        != labels[np.uint64(y), np.uint64(x)]
    )


@cache
def make_dense_nnf(width: int, step: int, lanes: int) -> Callable[..., None]:
    """Build ``dense_nnf`` for patches of ``width`` x ``width`` pixels of ``lanes`` bytes.

    Each pixel takes the match of least energy among those of the one, two or four entries whose
    patches cover it, moved by its way from them; the first of equals, and one of its label, if
    there is any. The pass is called with

    - ``nnf``, (rows, columns) int32;
    - ``source``, ``guides``, ``style`` and ``weights`` as the search is;
    - ``labels`` and ``source_labels``, (height, width) uint8, of no pixels if there are none;
    - ``out``, (height, width) int32;
    - ``stop``, (1,) uint8; once it is not 0, no further row is matched.
    """
    radius, length = width // 2, row_lanes(width, lanes)
    widen = make_widen(width, width, lanes)
    ssd = make_patch_ssd(width, length)

    @kernel(width, step, lanes, nogil=True)
    def dense_nnf(
        nnf: NDArray[np.int32],
        source: Image,
        guides: Image,
        style: Image,
        weights: NDArray[np.int16],
        labels: NDArray[np.uint8],
        source_labels: NDArray[np.uint8],
        out: NDArray[np.int32],
        stop: NDArray[np.uint8],
    ) -> None:
        rows, columns = nnf.shape
        first_y, last_y = first_centre(source.height, radius), last_centre(source.height, radius)
        first_x, last_x = first_centre(source.width, radius), last_centre(source.width, radius)
        stride, values = source.stride * lanes, source.values
        origin = (source.border - radius) * (source.stride + 1) * lanes
        target_origin = (style.border - radius) * (style.stride + 1)
        alike = alike_in_pairs(weights)
        for row in prange(out.shape[0]):
            if stop[0]:
                continue
            y = np.int64(row)
            patch = np.empty(width * length, np.int16)
            top, bottom = covering_entries(y, step, radius, rows)
            for x in range(out.shape[1]):
                left, right = covering_entries(x, step, radius, columns)
                entry = nnf[np.uint64(top), np.uint64(left)]
                best_y = min(max(row_of(entry) + y - top * step, first_y), last_y)
                best_x = min(max(column_of(entry) + x - left * step, first_x), last_x)
                best = np.int64(-1)  # not known: most pixels have one match alone
                for a in range(top, bottom + 1):
                    for b in range(left, right + 1):
                        entry = nnf[np.uint64(a), np.uint64(b)]
                        new_y = min(max(row_of(entry) + y - a * step, first_y), last_y)
                        new_x = min(max(column_of(entry) + x - b * step, first_x), last_x)
                        if new_y == best_y and new_x == best_x:
                            continue
                        if _forbids(labels, source_labels, y, x, new_y, new_x):
                            continue
                        if best < 0:
                            at = target_origin + y * style.stride + x
                            widen(
                                patch, guides.values, at * lanes, style.stride * lanes,
                                style.values, at * STYLE_LANES, style.stride * STYLE_LANES,
                            )  # fmt: skip
                            at = origin + best_y * stride + best_x * lanes
                            best = np.int64(ssd(values, at, stride, patch, 0, weights, alike))
                            if _forbids(labels, source_labels, y, x, best_y, best_x):
                                best = np.int64(2**31 - 1)
                        at = origin + new_y * stride + new_x * lanes
                        found = np.int64(ssd(values, at, stride, patch, 0, weights, alike))
                        if found < best:
                            best, best_y, best_x = found, new_y, new_x
                out[np.uint64(y), np.uint64(x)] = packed(best_y, best_x)

    return dense_nnf


@cache
def make_vote(width: int) -> Callable[..., None]:
    """Build ``vote(nnf, style, out, stop)``: the mean of all patches over a pixel.

    ``out`` is (height, width, 3) uint8; once ``stop``, (1,) uint8, is not 0, no row is made.
    """
    radius = width // 2

    @kernel(width, nogil=True)
    def vote(
        nnf: NDArray[np.int32], style: Image, out: NDArray[np.uint8], stop: NDArray[np.uint8]
    ) -> None:
        height, columns = nnf.shape
        for row in prange(height):
            if stop[0]:
                continue
            y = np.int64(row)
            above, below = max(y - radius, 0), min(y + radius, height - 1)
            for x in range(columns):
                before, after = max(x - radius, 0), min(x + radius, columns - 1)
                red, green, blue = np.uint32(0), np.uint32(0), np.uint32(0)
                for a in range(above, below + 1):
                    for b in range(before, after + 1):
                        entry = nnf[np.uint64(a), np.uint64(b)]
                        from_y = row_of(entry) + y - a + style.border
                        from_x = column_of(entry) + x - b + style.border
                        at = np.uint64((from_y * style.stride + from_x) * STYLE_LANES)
                        red += np.uint32(style.values[at])
                        green += np.uint32(style.values[at + np.uint64(1)])
                        blue += np.uint32(style.values[at + np.uint64(2)])
                count = (below - above + 1) * (after - before + 1)
                out[np.uint64(y), np.uint64(x), 0] = mean_of(red, count)
                out[np.uint64(y), np.uint64(x), 1] = mean_of(green, count)
                out[np.uint64(y), np.uint64(x), 2] = mean_of(blue, count)

    return vote
