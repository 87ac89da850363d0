"""B' from the NNF: the mean of the one, two or four patches over a pixel (equation 17)."""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.vector_patch import STYLE_LANES, cell_bytes, make_blend_cell
from stylit_ref.realtime.formulae.grid import covered_from_left, covered_from_right
from stylit_ref.realtime.formulae.packed_nnf import column_of, row_of
from stylit_ref.realtime.passes.border import extend_row, put_row
from stylit_ref.realtime.passes.image import Image
from stylit_ref.realtime.passes.moving import any_moves, cell_moves


@inlined
def _copy_cell(line, first, pixels, start, length):
    for i in range(np.uint64(length)):
        line[np.uint64(first) + i] = pixels[np.uint64(start) + i]


@cache
def make_blend(width: int, step: int, channels: int) -> Callable[..., None]:
    """Build ``blend(nnf, style, out, moving)`` for patches of ``width`` pixels, ``step`` apart.

    ``channels`` is 4 for an image with a border, which is filled too, and 3 for the picture.
    ``moving``, (rows, columns) uint8, is 0 for entries that are as they were when ``out`` was last
    blended. Pixels that only such entries cover may be left as they are. It has no entries if all
    may differ.
    """
    radius = width // 2
    cell = make_blend_cell(
        covered_from_left(step, radius), covered_from_right(step, radius), channels
    )
    spare = cell_bytes(step)

    @kernel(width, step, channels, nogil=True)
    def blend(nnf: NDArray[np.int32], style: Image, out: Image, moving: NDArray[np.uint8]) -> None:
        rows, columns = nnf.shape
        stride = out.stride * channels
        for row in prange(out.height):
            y = np.int64(row)
            a = y // step
            above = y - a * step
            if above > radius and a + 1 < rows:
                a, above = a + 1, above - step
            a2, below = a, above
            if above > 0 and step - above <= radius and a + 1 < rows:
                a2, below = a + 1, above - step
            origin = style.border * (style.stride + 1)
            upper = origin + above * style.stride
            lower = origin + below * style.stride
            if moving.size and not any_moves(moving, a) and not any_moves(moving, a2):
                continue
            start = (y + out.border) * stride + out.border * channels
            line = np.empty(columns * step * channels + spare, np.uint8)
            for b in range(columns):
                if moving.size and not cell_moves(moving, a, a2, b, min(b + 1, columns - 1)):
                    first = b * step * channels
                    length = min(step, out.width - b * step) * channels
                    _copy_cell(line, first, out.values, start + first, length)
                    continue
                entry, other = nnf[np.uint64(a), np.uint64(b)], nnf[np.uint64(a2), np.uint64(b)]
                one = upper + row_of(entry) * style.stride + column_of(entry)
                two = lower + row_of(other) * style.stride + column_of(other)
                one_right, two_right = one, two
                if b + 1 < columns:
                    entry = nnf[np.uint64(a), np.uint64(b + 1)]
                    other = nnf[np.uint64(a2), np.uint64(b + 1)]
                    one_right = upper + row_of(entry) * style.stride + column_of(entry) - step
                    two_right = lower + row_of(other) * style.stride + column_of(other) - step
                cell(
                    line, b * step * channels, style.values, one * STYLE_LANES,
                    one_right * STYLE_LANES, two * STYLE_LANES, two_right * STYLE_LANES,
                )  # fmt: skip
            put_row(out.values, start, line, out.width * channels)
            extend_row(out, y, np.int64(channels))

    return blend
