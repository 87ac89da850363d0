"""B' from the NNF: a thread for each pixel, which reads one, two or four patches."""

from numba import cuda

from gpu_cuda.host.argument_types import INT, MAP
from gpu_cuda.host.device import device_function
from gpu_cuda.realtime.formulae import column_of, mean_of_four, row_of
from gpu_cuda.realtime.image import IMAGE, address, launch_whole, nearest
from gpu_cuda.realtime.moving import MOVING
from stylit_ref.machine.vector_patch import STYLE_LANES


@device_function
def first_covering(place, step, radius, entries):
    """The first row, or column, of entries that covers a row of pixels; or the last of all."""
    near = place // step
    return near + 1 if place - near * step > radius and near + 1 < entries else near


@device_function
def last_covering(place, step, radius, entries):
    """The last such row; where there is but one it is the first."""
    near = place // step
    return near + 1 if near + 1 < entries and (near + 1) * step - place <= radius else near


@device_function
def shown(nnf, style, a, b, step, row, column):
    """Where an entry's patch has what it shows at a pixel of the target."""
    y, x = row_of(nnf[a, b]) + row - a * step, column_of(nnf[a, b]) + column - b * step
    return address(style, y, x, STYLE_LANES)


@cuda.jit
def blend_kernel(nnf, style, out, moving, radius, step, channels):
    x, y = cuda.grid(2)
    if x >= out.stride or y >= out.height + 2 * out.border:
        return
    row, column = nearest(y, out.border, out.height), nearest(x, out.border, out.width)
    rows, columns = nnf.shape
    a, b = first_covering(row, step, radius, rows), first_covering(column, step, radius, columns)
    a2, b2 = last_covering(row, step, radius, rows), last_covering(column, step, radius, columns)
    if moving.size and not (moving[a, b] or moving[a, b2] or moving[a2, b] or moving[a2, b2]):
        return
    one = shown(nnf, style, a, b, step, row, column)
    two = shown(nnf, style, a, b2, step, row, column)
    three = shown(nnf, style, a2, b, step, row, column)
    four = shown(nnf, style, a2, b2, step, row, column)
    to = (y * out.stride + x) * channels
    for c in range(channels):
        out.values[to + c] = mean_of_four(
            style.values[one + c], style.values[two + c],
            style.values[three + c], style.values[four + c],
        )  # fmt: skip


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "realtime: blend", blend_kernel, (MAP, IMAGE, IMAGE, MOVING, INT, INT, INT)


def make_blend(width, step, channels):
    """As :func:`stylit_ref.realtime.passes.make_blend`."""

    def blend(nnf, style, out, moving):
        launch_whole(blend_kernel, out, nnf, style, out, moving, width // 2, step, channels)

    return blend
