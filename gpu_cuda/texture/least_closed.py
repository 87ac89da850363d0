"""The reduction to the least closed path of every patch: a block of threads for each."""

from functools import lru_cache

from numba import cuda, int32, types

from gpu_cuda.host.argument_types import INT, MAP
from gpu_cuda.host.device import device_function, launch
from gpu_cuda.texture.blocks import Blocks
from gpu_cuda.texture.steps import COLUMNS

TABLE = types.int32[:, ::1]
INFINITE = (1 << 31) - 1


@device_function
def arrives_at(arrivals, left, end):
    """The column of the first row from which the path to the column ``end`` starts."""
    x = end
    for line in range(arrivals.shape[0] - 1, -1, -1):
        x = arrivals[line, left + x]
    return x


@lru_cache
def make_kernel(threads):
    """Compile the kernel for blocks of so many threads."""

    @cuda.jit
    def choose_kernel(totals, max_jump, starts, arrivals, begins, costs):
        least = cuda.shared.array(threads, int32)
        where = cuda.shared.array(threads, int32)
        thread, patch = cuda.threadIdx.x, cuda.blockIdx.y
        rows = totals.shape[0] - 1
        padded = totals.shape[1] // starts.size
        columns = padded - 2 * max_jump
        first, left = patch * padded + max_jump, patch * columns
        least[thread], where[thread] = INFINITE, INFINITE
        for end in range(thread, columns, threads):
            total = totals[rows, first + end]
            if total < least[thread] and arrives_at(arrivals, left, end) == end:
                least[thread], where[thread] = total, end
        cuda.syncthreads()
        if thread == 0:
            end = starts[patch]
            if end < 0:  # any column will do: of equal ones the first
                best, end = least[0], where[0]
                for other in range(1, threads):
                    if least[other] < best or (least[other] == best and where[other] < end):
                        best, end = least[other], where[other]
            costs[patch] = totals[rows, first + end]
            x = end
            for line in range(arrivals.shape[0] - 1, -1, -1):
                begins[patch, line] = x
                x = arrivals[line, left + x]

    return choose_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    kernel = make_kernel(Blocks.default(4).threads)
    yield "texture: choose", kernel, (MAP, INT, COLUMNS, TABLE, TABLE, COLUMNS)


def choose(totals, max_jump, starts, arrivals, begins, costs, threads):
    """Choose the least closed path of every patch.

    Parameters
    ----------
    begins : (n, lines) int32
        Receives its column below every line of blocks.
    costs : (n,) int32
        Receives what it costs.
    """
    launch(
        make_kernel(threads), (starts.size, threads), totals, max_jump, starts, arrivals, begins,
        costs, block=(threads, 1),
    )  # fmt: skip
