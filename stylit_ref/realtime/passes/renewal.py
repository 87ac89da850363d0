"""A warm frame takes matches of a coarse level where those of the last frame have grown old."""

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
from stylit_ref.realtime.formulae.grid import first_centre, last_centre
from stylit_ref.realtime.formulae.packed_nnf import column_of, packed, row_of
from stylit_ref.realtime.formulae.renewal import coarse, fine, is_old
from stylit_ref.realtime.passes.image import Image
from stylit_ref.realtime.passes.search import FREE, Grid


@inlined
def _is_allowed(label, source_labels, y, x):
    return label == FREE or source_labels[np.uint64(y), np.uint64(x)] == label


@inlined
def _label(labels, a, b):
    return np.int64(labels[np.uint64(a), np.uint64(b)]) if labels.size else np.int64(FREE)


@cache
def make_renew(rows: int, pixels: int, lanes: int) -> Callable[..., None]:
    """Build ``renew`` for patches of ``rows`` x ``pixels`` pixels of ``lanes`` bytes.

    A block of entries, those of level 0 under one of a coarser level, is old where the guides say
    so at that level, or a label. All its entries then take the fresh match; where a label forbids
    it, they keep their own. Elsewhere entries take it whose label forbids their own match.

    The pass is called with

    - ``nnf``, (rows, columns) int32, that of level 0, changed in place;
    - ``fresh``, (rows, columns) int32, that of ``level``, searched from nothing;
    - ``source``, ``guides``, ``style``, ``weights`` and ``grid`` of ``level`` as ``search`` takes
      them, but weights of the guides alone;
    - ``height``, ``width`` of the source at level 0, and ``fine_grid``, the :class:`Grid` there.
    """
    length = row_lanes(pixels, lanes)
    unit, style_unit = (lanes, STYLE_LANES) if rows > 1 else (lanes * pixels, STYLE_LANES * pixels)
    reach = pixels // 2 if rows > 1 else 0
    widen = make_widen(rows, pixels, lanes)
    ssd = make_patch_ssd(rows, length)

    @kernel(rows, pixels, lanes, nogil=True)
    def renew(
        nnf: NDArray[np.int32],
        fresh: NDArray[np.int32],
        level: int,
        source: Image,
        guides: Image,
        style: Image,
        weights: NDArray[np.int16],
        grid: Grid,
        height: int,
        width: int,
        fine_grid: Grid,
    ) -> None:
        step, margin = grid.step, grid.margin
        first_y, last_y = first_centre(source.height, margin), last_centre(source.height, margin)
        first_x, last_x = first_centre(source.width, margin), last_centre(source.width, margin)
        top, bottom = first_centre(height, margin), last_centre(height, margin)
        left, right = first_centre(width, margin), last_centre(width, margin)
        stride, target_stride = source.stride * unit, style.stride
        origin = (source.border - reach) * (source.stride + 1) * unit
        target_origin = (style.border - reach) * (style.stride + 1)
        alike = alike_in_pairs(weights)
        for row in prange(fresh.shape[0]):
            a = np.int64(row)
            patch = np.empty(rows * length, np.int16)
            for b in range(fresh.shape[1]):
                at = target_origin + (a * target_stride + b) * grid.spacing
                widen(
                    patch, guides.values, at * unit, target_stride * unit,
                    style.values, at * style_unit, target_stride * style_unit,
                )  # fmt: skip
                entry = nnf[a << level, b << level]
                own_y = min(max(coarse(row_of(entry), level), first_y), last_y)
                own_x = min(max(coarse(column_of(entry), level), first_x), last_x)
                y, x = row_of(fresh[a, b]), column_of(fresh[a, b])
                at = origin + own_y * stride + own_x * unit
                own = np.int64(ssd(source.values, at, stride, patch, 0, weights, alike))
                at = origin + y * stride + x * unit
                new = np.int64(ssd(source.values, at, stride, patch, 0, weights, alike))
                label = _label(grid.labels, a, b)
                old = is_old(own, new) or not _is_allowed(label, grid.source_labels, own_y, own_x)
                for i in range(a << level, min((a + 1) << level, nnf.shape[0])):
                    for j in range(b << level, min((b + 1) << level, nnf.shape[1])):
                        entry = nnf[i, j]
                        label = _label(fine_grid.labels, i, j)
                        labels = fine_grid.source_labels
                        if not old and _is_allowed(label, labels, row_of(entry), column_of(entry)):
                            continue
                        new_y = min(max(fine(y, level, step, i, a), top), bottom)
                        new_x = min(max(fine(x, level, step, j, b), left), right)
                        if _is_allowed(label, labels, new_y, new_x):
                            nnf[i, j] = packed(new_y, new_x)

    return renew
