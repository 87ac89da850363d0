"""Backtracking in blocks: all paths are followed through all lines of blocks at once.

From every column below a line of blocks, a thread follows the best path up through the line, and
notes the column in which it arrives. (So no launch must wait for another, at the cost of a table
for all lines, as the paper suggests where memory allows.) The path from the last row to the first
is then one look-up a line.
"""

from numba import cuda, types

from gpu_cuda.host.argument_types import INT, MAP
from gpu_cuda.host.device import launch
from gpu_cuda.texture.steps import came_from

TABLE = types.int32[:, ::1]


@cuda.jit
def arrive_kernel(totals, steps, max_jump, patches, block_rows, origins):
    end, line = cuda.grid(2)
    rows = steps.shape[0]
    padded = steps.shape[1] // patches
    columns = padded - 2 * max_jump
    if end >= patches * columns or line >= origins.shape[0]:
        return
    left = end // columns * padded + max_jump
    x = left + end % columns
    top = line * block_rows
    for y in range(min(top + block_rows, rows), top, -1):
        x = came_from(totals[y - 1], steps[y - 1], x, left, left + columns, max_jump)
    origins[line, end] = x - left


@cuda.jit
def follow_kernel(totals, steps, max_jump, begins, block_rows, paths):
    patch, line = cuda.grid(2)
    rows, patches = steps.shape[0], paths.shape[0]
    padded = steps.shape[1] // patches
    columns = padded - 2 * max_jump
    if patch >= patches or line >= begins.shape[1]:
        return
    left = patch * padded + max_jump
    x = left + begins[patch, line]
    top = line * block_rows
    for y in range(min(top + block_rows, rows), top, -1):
        x = came_from(totals[y - 1], steps[y - 1], x, left, left + columns, max_jump)
        paths[patch, y - 1] = x - left


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    arrive = MAP, MAP, INT, INT, INT, TABLE
    yield "texture: arrive", arrive_kernel, arrive
    yield "texture: follow", follow_kernel, (MAP, MAP, INT, TABLE, INT, TABLE)


def arrive(totals, steps, max_jump, patches, block_rows, origins):
    """Find where the path from every column below every line of blocks arrives above it.

    Parameters
    ----------
    origins : (lines, n W) int32
        Receives the columns, of 0 to W - 1.
    """
    launch(arrive_kernel, origins.shape, totals, steps, max_jump, patches, block_rows, origins)


def follow(totals, steps, max_jump, begins, block_rows, paths):
    """Write the path of every patch.

    Parameters
    ----------
    begins : (n, lines) int32
        The column of each path below each line of blocks.
    paths : (n, H) int32
        Receives the columns.
    """
    patches, lines = begins.shape
    launch(follow_kernel, (lines, patches), totals, steps, max_jump, begins, block_rows, paths)
