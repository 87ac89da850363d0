"""The cuts of many patches at once, their tables side by side (section 7)."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.texture.passes.cut import accumulate, closed_path


@kernel()
def _best_cuts(crossing, steps, max_jump, arrivals, totals, paths, costs):
    padded = crossing.shape[1] // costs.size
    for patch in prange(costs.size):
        first, end = patch * padded, (patch + 1) * padded
        # Copies: the loops over a row are made for arrays of their own.
        row_costs, row_steps = crossing[:, first:end].copy(), steps[:, first:end].copy()
        table = np.empty((crossing.shape[0] + 1, padded), np.int32)
        room = np.empty((4, padded + 1), np.int32)
        arrived = arrivals[first:end].copy()
        accumulate(
            row_costs, row_steps, max_jump, arrived, table, room[0, :padded], room[1, :padded]
        )
        costs[patch] = closed_path(
            table, row_steps, max_jump, arrived, paths[patch], room[2], room[3]
        )
        totals[:, first:end] = table


def best_cuts(
    crossing: NDArray[np.int32],
    steps: NDArray[np.int32],
    max_jump: int,
    arrivals: NDArray[np.int32],
    totals: NDArray[np.int32],
    paths: NDArray[np.int32],
    costs: NDArray[np.int32],
) -> None:
    """Find for each of n patches the cheapest closed path that the dynamic programming finds.

    The tables of the patches lie side by side. Each has W columns of its own and J more on either
    side, whose crossings are BLOCKED.

    Parameters
    ----------
    crossing, steps : (H, n (W + 2 J)) int32
        As :func:`stylit_ref.texture.passes.cut.accumulate` takes them.
    max_jump : int
    arrivals : (n (W + 2 J),) int32
        What it costs to arrive in each column of the first row.
    totals : (H + 1, n (W + 2 J)) int32
        Receives T.
    paths : (n, H) int32
        Receive the paths: a column of 0 to W - 1 for every row.
    costs : (n,) int32
        Receive what they cost.
    """
    _best_cuts(crossing, steps, max_jump, arrivals, totals, paths, costs)
