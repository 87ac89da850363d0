"""From a level to the next finer one (5.2.4): the NNF, and B' as the thesis has it."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.machine.vector_pixel import make_double_pixel
from stylit_ref.randomness.random_stream import random_words
from stylit_ref.realtime.formulae.grid import first_centre, last_centre
from stylit_ref.realtime.formulae.packed_nnf import column_of, packed, row_of
from stylit_ref.realtime.formulae.random_candidate import random_column, random_row
from stylit_ref.realtime.formulae.upsampling import upsampled
from stylit_ref.realtime.passes.border import extend_row
from stylit_ref.realtime.passes.image import Image


@kernel(parallel=False, nogil=True)
def random_nnf(
    nnf: NDArray[np.int32],
    height: int,
    width: int,
    margin: int,
    stream: tuple[int, int, int, int],
) -> None:
    """Fill the NNF with random centres of a source of ``height`` x ``width`` pixels.

    The coarsest level has few entries, so one thread is enough.
    """
    rows, columns = nnf.shape
    first_y, last_y = first_centre(height, margin), last_centre(height, margin)
    first_x, last_x = first_centre(width, margin), last_centre(width, margin)
    draw = np.int64(0)  # of the type that the search gives: a constant would be compiled anew
    for a in range(rows):
        for b in range(columns):
            word = random_words(stream, a * columns + b, draw)[0]
            nnf[a, b] = packed(
                random_row(word, first_y, last_y), random_column(word, first_x, last_x)
            )


@kernel(nogil=True)
def upsample_nnf(
    coarse: NDArray[np.int32],
    nnf: NDArray[np.int32],
    height: int,
    width: int,
    margin: int,
    step: int,
) -> None:
    """Fill the NNF from that of the next coarser level, for a source of ``height`` x ``width``."""
    rows, columns = nnf.shape
    first_y, last_y = first_centre(height, margin), last_centre(height, margin)
    first_x, last_x = first_centre(width, margin), last_centre(width, margin)
    for row in prange(rows):
        a = np.int64(row)
        parent_a = min(a // 2, coarse.shape[0] - 1)
        for b in range(columns):
            parent_b = min(b // 2, coarse.shape[1] - 1)
            entry = coarse[np.uint64(parent_a), np.uint64(parent_b)]
            y = upsampled(row_of(entry), step, a, parent_a)
            x = upsampled(column_of(entry), step, b, parent_b)
            nnf[np.uint64(a), np.uint64(b)] = packed(
                min(max(y, first_y), last_y), min(max(x, first_x), last_x)
            )


_double_pixel = make_double_pixel(STYLE_LANES)


@kernel(nogil=True)
def upsample_picture(coarse: Image, out: Image) -> None:
    """B' from the next coarser level by bilinear interpolation."""
    lanes = STYLE_LANES
    for row in prange(out.height):
        y = np.int64(row)
        y0 = y // 2
        y1 = y0 + 1 if y % 2 else y0 - 1
        near = ((y0 + coarse.border) * coarse.stride + coarse.border) * lanes
        far = ((y1 + coarse.border) * coarse.stride + coarse.border) * lanes
        start = ((y + out.border) * out.stride + out.border) * lanes
        for x in range(0, coarse.width * lanes, lanes):
            _double_pixel(out.values, start + 2 * x, coarse.values, near + x, far + x)
        extend_row(out, y, np.int64(lanes))
