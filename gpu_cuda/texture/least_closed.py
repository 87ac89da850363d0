"""The reduction to the least closed path of every patch: a block of threads for each."""

from functools import lru_cache

from numba import cuda, int32, types

from gpu_cuda.host.argument_types import INT, MAP
from gpu_cuda.host.device import device_function, launch
from gpu_cuda.texture.blocks import Blocks
from gpu_cuda.texture.steps import BLOCKED, COLUMNS

TABLE = types.int32[:, ::1]
INFINITE = (1 << 31) - 1


@device_function
def begins_at(origins, left, end):
    """The column of the first row from which the path to the column ``end`` starts."""
    x = end
    for line in range(origins.shape[0] - 1, -1, -1):
        x = origins[line, left + x]
    return x


@device_function
def closed_cost(total, arrival):
    """What a closed path costs that ends at ``total`` where it began at ``arrival``."""
    return total - arrival if total < BLOCKED // 2 else total


@lru_cache
def make_kernel(threads):
    """Compile the kernel for blocks of so many threads."""

    @cuda.jit
    def choose_kernel(totals, max_jump, arrivals, origins, begins, costs):
        least = cuda.shared.array(threads, int32)
        where = cuda.shared.array(threads, int32)
        thread, patch = cuda.threadIdx.x, cuda.blockIdx.y
        rows = totals.shape[0] - 1
        padded = totals.shape[1] // costs.size
        columns = padded - 2 * max_jump
        first, left = patch * padded + max_jump, patch * columns
        least[thread], where[thread] = INFINITE, INFINITE
        for end in range(thread, columns, threads):
            cost = closed_cost(totals[rows, first + end], arrivals[first + end])
            if cost < least[thread] and begins_at(origins, left, end) == end:
                least[thread], where[thread] = cost, end
        cuda.syncthreads()
        if thread == 0:
            best, x = least[0], where[0]
            for other in range(1, threads):  # of equal ones the first
                if least[other] < best or (least[other] == best and where[other] < x):
                    best, x = least[other], where[other]
            costs[patch] = best
            for line in range(origins.shape[0] - 1, -1, -1):
                begins[patch, line] = x
                x = origins[line, left + x]

    return choose_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    kernel = make_kernel(Blocks.default(4).threads)
    yield "texture: choose", kernel, (MAP, INT, COLUMNS, TABLE, TABLE, COLUMNS)


def choose(totals, max_jump, arrivals, origins, begins, costs, threads):
    """Choose the least closed path of every patch.

    Parameters
    ----------
    begins : (n, lines) int32
        Receives its column below every line of blocks.
    costs : (n,) int32
        Receives what it costs.
    """
    launch(
        make_kernel(threads), (costs.size, threads), totals, max_jump, arrivals, origins, begins,
        costs, block=(threads, 1),
    )  # fmt: skip
