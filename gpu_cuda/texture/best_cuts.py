"""The cuts of many patches at once, and the alignments along them: the same dynamic programming."""

import numpy as np

from gpu_cuda.host.memory import empty
from gpu_cuda.texture.accumulate import accumulate
from gpu_cuda.texture.backtrack import arrive, follow
from gpu_cuda.texture.blocks import Blocks
from gpu_cuda.texture.least_closed import choose


def best_cuts(crossing, steps, max_jump, arrivals, totals, paths, costs):
    """As :func:`stylit_ref.texture.passes.best_cuts`, on device arrays."""
    in_blocks(Blocks.default(max_jump), crossing, steps, max_jump, arrivals, totals, paths, costs)


def in_blocks(blocks, crossing, steps, max_jump, arrivals, totals, paths, costs):
    """The same in blocks of a given size, which changes nothing but the time."""
    patches, rows = paths.shape
    padded = crossing.shape[1] // patches
    lines = -(-rows // blocks.rows)
    accumulate(crossing, steps, max_jump, arrivals, patches, totals, blocks)
    origins = empty((lines, patches * (padded - 2 * max_jump)), np.int32)
    begins = empty((patches, lines), np.int32)
    arrive(totals, steps, max_jump, patches, blocks.rows, origins)
    choose(totals, max_jump, arrivals, origins, begins, costs, blocks.threads)
    follow(totals, steps, max_jump, begins, blocks.rows, paths)
