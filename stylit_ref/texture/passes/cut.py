"""The dynamic programming of sections 4 and 5: T[y, i], and the best path that closes."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined, subroutine
from stylit_ref.texture.formulae.polar import BLOCKED


@subroutine
def accumulate(
    crossing: NDArray[np.int32],
    steps: NDArray[np.int32],
    max_jump: int,
    arrivals: NDArray[np.int32],
    totals: NDArray[np.int32],
    less: NDArray[np.int32],
    more: NDArray[np.int32],
) -> None:
    """Fill T from top to bottom.

    ::

        T[0, i] = arrivals[i] + crossing[0, i]
        T[y, i] = min over |i - j| <= J of (T[y - 1, j] + |V[i] - V[j]|) + crossing[y, i]

    where V are the running sums of the steps between the rows y - 1 and y. Since these are sums,
    the minimum is that of two sliding minima, of T - V on the left and of T + V on the right. It is
    at most BLOCKED, as T is, since to stay in a column costs no step. The table has one row more
    than there are rows: the first again, without its crossing, so that the jump that closes a cut
    pays its step.

    Parameters
    ----------
    crossing, steps : (H, W + 2 J) int32
        With J columns more on either side; the crossings there are BLOCKED.
    max_jump : int
        J.
    arrivals : (W + 2 J,) int32
        What it costs to arrive in each column of the first row, at most BLOCKED: 0 where a cut may
        begin anywhere.
    totals : (H + 1, W + 2 J) int32
        Receives T.
    less, more : (W + 2 J,) int32
        Room to compute in.
    """
    rows, padded = crossing.shape
    columns = padded - 2 * max_jump
    last = max_jump + columns
    blocked = np.int32(BLOCKED)
    row, costs = totals[0], crossing[0]
    for x in range(padded):
        total = np.int32(arrivals[x] + costs[x])
        row[x] = total if total < blocked else blocked
    for y in range(1, rows + 1):
        before, running = totals[y - 1], steps[y - 1]
        for x in range(padded):
            less[x] = before[x] - running[x]
            more[x] = before[x] + running[x]
        inner, best = running[max_jump:last], totals[y, max_jump:last]
        if max_jump == 8:
            _best_of_8(less, more, inner, best)
        elif max_jump == 4:
            _best_of_4(less, more, inner, best)
        elif max_jump == 1:
            _best_of_1(less, more, inner, best)
        else:
            _best_of_any(less, more, inner, max_jump, best)
        totals[y, :max_jump] = blocked
        totals[y, last:] = blocked
        if y < rows:
            costs = crossing[y, max_jump:last]
            for x in range(columns):
                total = np.int32(best[x] + costs[x])
                best[x] = total if total < blocked else blocked


def _make_best(max_jump):
    """The sliding minima for one J: an inner loop of fixed length becomes vector instructions."""

    @inlined
    def best_of(less, more, running, best):
        for x in range(best.size):
            at = np.uint64(x)
            left, right = less[at + np.uint64(max_jump)], more[at + np.uint64(max_jump)]
            for jump in range(1, max_jump + 1):
                left = _least(left, less[at + np.uint64(max_jump - jump)])
                right = _least(right, more[at + np.uint64(max_jump + jump)])
            best[at] = _least(np.int32(left + running[at]), np.int32(right - running[at]))

    return best_of


_best_of_1, _best_of_4, _best_of_8 = _make_best(1), _make_best(4), _make_best(8)


@inlined
def _best_of_any(less, more, running, max_jump, best):
    columns = best.size
    for x in range(columns):
        best[x] = np.int32(less[max_jump + x] + running[x])
    for jump in range(max_jump + 1):
        left = less[max_jump - jump : max_jump - jump + columns]
        right = more[max_jump + jump : max_jump + jump + columns]
        for x in range(columns):
            nearer = _least(np.int32(left[x] + running[x]), np.int32(right[x] - running[x]))
            best[x] = _least(best[x], nearer)


@inlined
def _least(a, b):
    return a if a < b else b


@inlined
def _came_from(totals, steps, y, x, max_jump):
    """The column in row y - 1 from which the best path reaches column x of row y.

    Of several, that farthest to the left. The columns that were added on either side do not count:
    where all others are blocked, a path would leave the table through them.
    """
    best, origin = np.int32(2147483647), x
    last = totals.shape[1] - max_jump
    for j in range(max(x - max_jump, max_jump), min(x + max_jump + 1, last)):
        total = np.int32(totals[y - 1, j] + abs(np.int32(steps[y - 1, x] - steps[y - 1, j])))
        if total < best:
            best, origin = total, j
    return origin


@inlined
def _closed_cost(total, arrival):
    """What a closed path costs that ends at ``total`` where it began at ``arrival``."""
    return np.int32(total - arrival if total < BLOCKED // 2 else total)


@subroutine
def closed_path(
    totals: NDArray[np.int32],
    steps: NDArray[np.int32],
    max_jump: int,
    arrivals: NDArray[np.int32],
    path: NDArray[np.int32],
    ends: NDArray[np.int32],
    columns_now: NDArray[np.int32],
) -> int:
    """The cheapest of the best paths to every end that starts in the column where it ends.

    There is one (Appendix B), since best paths never cross: ties go to the left. All are followed
    upwards together; where two meet they stay together, and are followed as one.

    Parameters
    ----------
    totals : (H + 1, W + 2 J) int32
        T.
    steps : (H, W + 2 J) int32
    max_jump : int
    arrivals : (W + 2 J,) int32
        As T was filled.
    path : (H,) int32
        Receives the path: a column of 0 to W - 1 for every row.
    ends, columns_now : (W + 1,) int32
        Room to compute in.

    Returns
    -------
    int
        What the path costs: the total at its end less the arrival where it began. BLOCKED // 2 or
        more if the totals of all closed paths are.
    """
    rows, padded = steps.shape
    columns = padded - 2 * max_jump
    groups = columns
    for i in range(columns):
        ends[i], columns_now[i] = i, i + max_jump
    ends[groups] = columns
    for y in range(rows, 0, -1):
        kept, last = 0, -1
        for group in range(groups):
            origin = _came_from(totals, steps, y, columns_now[group], max_jump)
            if origin != last:
                ends[kept], columns_now[kept] = ends[group], origin
                kept += 1
                last = origin
        groups = kept
        ends[groups] = columns
    best_end, best = np.int64(-1), np.int32(2147483647)
    for group in range(groups):
        end = np.int64(columns_now[group])
        closes = ends[group] <= end - max_jump < ends[group + 1]
        cost = _closed_cost(totals[rows, end], arrivals[end])
        if closes and cost < best:
            best_end, best = end, cost
    x = best_end
    for y in range(rows, 0, -1):
        x = _came_from(totals, steps, y, x, max_jump)
        path[y - 1] = x - max_jump
    return best
