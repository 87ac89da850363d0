"""T[y, i], the table of the dynamic programming, line of blocks by line of blocks.

A block of threads takes the row above its own into shared memory, with the columns on either side
that its last row depends on, and computes row after row there. The next line of blocks begins when
this one has ended, since it is another launch. A block belongs to one patch and reads nothing
beyond its boundaries.
"""

from functools import lru_cache

from numba import cuda, int32

from gpu_cuda.host.argument_types import INT, MAP
from gpu_cuda.host.device import launch
from gpu_cuda.texture.blocks import Blocks
from gpu_cuda.texture.steps import BLOCKED, COLUMNS, transition


@lru_cache
def make_kernel(blocks, max_jump):
    """Compile the kernel for blocks of a size and a largest jump.

    Parameters
    ----------
    blocks : gpu_cuda.texture.blocks.Blocks
    max_jump : int
    """
    reach = blocks.rows * max_jump
    width = blocks.columns + 2 * reach
    block_columns, block_rows = blocks.columns, blocks.rows

    @cuda.jit
    def accumulate_kernel(crossing, steps, arrivals, patches, first, totals):
        before = cuda.shared.array(width, int32)
        after = cuda.shared.array(width, int32)
        running = cuda.shared.array(width, int32)
        thread, threads = cuda.threadIdx.x, cuda.blockDim.x
        patch = cuda.blockIdx.y
        rows = crossing.shape[0]
        padded = crossing.shape[1] // patches
        left = patch * padded  # of the patch, in the tables of all
        begin = cuda.blockIdx.x * block_columns - reach  # of the block, in the patch
        end_column = padded - max_jump
        if first > 0:
            for k in range(thread, width, threads):
                x = begin + k
                inside = max_jump <= x < end_column
                before[k] = totals[first - 1, left + x] if inside else BLOCKED
        for n in range(block_rows):
            y = first + n
            if y > rows:
                break
            for k in range(thread, width, threads):
                x = begin + k
                running[k] = steps[y - 1, left + x] if y > 0 and 0 <= x < padded else 0
            cuda.syncthreads()
            for k in range(thread, width, threads):
                x = begin + k
                total = BLOCKED
                if max_jump <= x < end_column:
                    if y == 0:
                        total = min(arrivals[left + x] + crossing[0, left + x], BLOCKED)
                    else:
                        # Near the ends of the block this lacks neighbours, and is not needed.
                        for other in range(max(k - max_jump, 0), min(k + max_jump + 1, width)):
                            total = min(total, transition(before, running, other, k))
                        if y < rows:
                            total = min(total + crossing[y, left + x], BLOCKED)
                after[k] = total
                if reach <= k < reach + block_columns and x < padded:
                    totals[y, left + x] = total
            cuda.syncthreads()
            for k in range(thread, width, threads):
                before[k] = after[k]

    return accumulate_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    for max_jump in (1, 4, 16):
        kernel = make_kernel(Blocks.default(max_jump), max_jump)
        yield f"texture: accumulate, J {max_jump}", kernel, (MAP, MAP, COLUMNS, INT, INT, MAP)


def accumulate(crossing, steps, max_jump, arrivals, patches, totals, blocks):
    """Fill T of all patches, a launch for every line of blocks."""
    padded = crossing.shape[1] // patches
    across = -(-padded // blocks.columns)
    kernel = make_kernel(blocks, max_jump)
    for first in range(0, totals.shape[0], blocks.rows):
        launch(
            kernel, (patches, across * blocks.threads), crossing, steps, arrivals, patches, first,
            totals, block=(blocks.threads, 1),
        )  # fmt: skip
