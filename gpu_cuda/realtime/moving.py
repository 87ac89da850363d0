"""The entries whose matches still move in a warm frame."""

from numba import cuda, types

from gpu_cuda.host.argument_types import MAP
from gpu_cuda.host.device import launch

MOVING = types.uint8[:, ::1]


@cuda.jit
def mark_moving_kernel(before, nnf, moving):
    b, a = cuda.grid(2)
    rows, columns = nnf.shape
    if a >= rows or b >= columns:
        return
    moves = 0
    for i in range(max(a - 1, 0), min(a + 2, rows)):
        for j in range(max(b - 1, 0), min(b + 2, columns)):
            if nnf[i, j] != before[i, j]:
                moves = 1
    moving[a, b] = moves


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "realtime: mark moving", mark_moving_kernel, (MAP, MAP, MOVING)


def mark_moving(before, nnf, moving):
    """As :func:`stylit_ref.realtime.passes.mark_moving`."""
    launch(mark_moving_kernel, nnf.shape, before, nnf, moving)
