"""A step of the dynamic programming: from a column of a row to one of the next."""

from numba import types

from gpu_cuda.host.device import device_function
from stylit_ref.texture.formulae.polar import BLOCKED

__all__ = ["BLOCKED", "COLUMNS", "came_from", "transition"]

COLUMNS = types.int32[::1]
"""The type of an array with a value for each patch, or each column."""


@device_function
def transition(totals, running, origin, x):
    """What a path costs that reaches column x from the column ``origin`` of the row above."""
    return totals[origin] + abs(running[x] - running[origin])


@device_function
def came_from(totals, running, x, first, end, max_jump):
    """The column from which the best path reaches column x: of several, that farthest to the left.

    ``first`` and ``end`` are the boundaries of the patch, without the columns added to it.
    """
    origin = max(x - max_jump, first)
    best = transition(totals, running, origin, x)
    for other in range(origin + 1, min(x + max_jump + 1, end)):
        total = transition(totals, running, other, x)
        if total < best:
            best, origin = total, other
    return origin
