"""From a level to the next finer one, and the NNF to begin with."""

from numba import cuda

from gpu_cuda.host.argument_types import INT, MAP, STREAM
from gpu_cuda.host.device import launch
from gpu_cuda.realtime.formulae import (
    bilinear,
    column_of,
    first_centre,
    last_centre,
    packed,
    random_column,
    random_row,
    random_words,
    row_of,
    upsampled,
)
from gpu_cuda.realtime.image import IMAGE, address, launch_whole, nearest
from stylit_ref.machine.vector_patch import STYLE_LANES


@cuda.jit
def random_entries_kernel(nnf, height, width, margin, stream):
    b, a = cuda.grid(2)
    if a >= nnf.shape[0] or b >= nnf.shape[1]:
        return
    word = random_words(stream, a * nnf.shape[1] + b, 0)[0]
    nnf[a, b] = packed(
        random_row(word, first_centre(height, margin), last_centre(height, margin)),
        random_column(word, first_centre(width, margin), last_centre(width, margin)),
    )


@cuda.jit
def upsample_entries_kernel(coarse, nnf, height, width, margin, step):
    b, a = cuda.grid(2)
    if a >= nnf.shape[0] or b >= nnf.shape[1]:
        return
    parent_a, parent_b = min(a // 2, coarse.shape[0] - 1), min(b // 2, coarse.shape[1] - 1)
    entry = coarse[parent_a, parent_b]
    y = upsampled(row_of(entry), step, a, parent_a)
    x = upsampled(column_of(entry), step, b, parent_b)
    nnf[a, b] = packed(
        min(max(y, first_centre(height, margin)), last_centre(height, margin)),
        min(max(x, first_centre(width, margin)), last_centre(width, margin)),
    )


@cuda.jit
def upsample_picture_kernel(coarse, out):
    x, y = cuda.grid(2)
    if x >= out.stride or y >= out.height + 2 * out.border:
        return
    row, column = nearest(y, out.border, out.height), nearest(x, out.border, out.width)
    near = address(coarse, row // 2, column // 2, STYLE_LANES)
    beside = STYLE_LANES if column % 2 else -STYLE_LANES
    below = coarse.stride * (STYLE_LANES if row % 2 else -STYLE_LANES)
    to = (y * out.stride + x) * STYLE_LANES
    for c in range(STYLE_LANES):
        at = near + c
        out.values[to + c] = bilinear(
            coarse.values[at], coarse.values[at + beside], coarse.values[at + below],
            coarse.values[at + below + beside],
        )  # fmt: skip


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "realtime: random NNF", random_entries_kernel, (MAP, INT, INT, INT, STREAM)
    yield "realtime: upsample NNF", upsample_entries_kernel, (MAP, MAP, INT, INT, INT, INT)
    yield "realtime: upsample picture", upsample_picture_kernel, (IMAGE, IMAGE)


def random_nnf(nnf, height, width, margin, stream):
    """As :func:`stylit_ref.realtime.passes.random_nnf`."""
    launch(random_entries_kernel, nnf.shape, nnf, height, width, margin, stream)


def upsample_nnf(coarse, nnf, height, width, margin, step):
    """As :func:`stylit_ref.realtime.passes.upsample_nnf`."""
    launch(upsample_entries_kernel, nnf.shape, coarse, nnf, height, width, margin, step)


def upsample_picture(coarse, out):
    """As :func:`stylit_ref.realtime.passes.upsample_picture`."""
    launch_whole(upsample_picture_kernel, out, coarse, out)
