"""The next coarser level of an image."""

from numba import cuda

from gpu_cuda.host.argument_types import INT
from gpu_cuda.realtime.formulae import mean_of_four
from gpu_cuda.realtime.image import IMAGE, address, launch_whole, nearest


@cuda.jit
def halve_kernel(fine, coarse, lanes):
    x, y = cuda.grid(2)
    if x >= coarse.stride or y >= coarse.height + 2 * coarse.border:
        return
    row = nearest(y, coarse.border, coarse.height)
    column = nearest(x, coarse.border, coarse.width)
    upper = address(fine, 2 * row, 2 * column, lanes)
    lower = upper + fine.stride * lanes
    to = (y * coarse.stride + x) * lanes
    for c in range(lanes):
        coarse.values[to + c] = mean_of_four(
            fine.values[upper + c], fine.values[upper + lanes + c],
            fine.values[lower + c], fine.values[lower + lanes + c],
        )  # fmt: skip


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "realtime: halve", halve_kernel, (IMAGE, IMAGE, INT)


def make_halve(lanes):
    """As :func:`stylit_ref.realtime.passes.make_halve`."""

    def halve(fine, coarse):
        launch_whole(halve_kernel, coarse, fine, coarse, lanes)

    return halve
