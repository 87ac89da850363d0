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
    first_row: int,
    start: int,
    totals: NDArray[np.int32],
    less: NDArray[np.int32],
    more: NDArray[np.int32],
) -> None:
    """Fill T from top to bottom.

    ::

        T[y, i] = min over |i - j| <= J of (T[y - 1, j] + |V[i] - V[j]|) + crossing[y, i]

    where V are the running sums of the steps between the rows y - 1 and y. Since these are sums,
    the minimum is that of two sliding minima, of T - V on the left and of T + V on the right. The
    table has one row more than there are rows: the first again, without its crossing, so that the
    jump that closes a cut pays its step.

    Parameters
    ----------
    crossing, steps : (H, W + 2 J) int32
        With J columns more on either side; the crossings there are BLOCKED.
    max_jump : int
        J.
    first_row : int
        The row that T begins with.
    start : int
        The one column to start from, or -1 for any.
    totals : (H + 1, W + 2 J) int32
        Receives T.
    less, more : (W + 2 J,) int32
        Room to compute in.
    """
    rows, padded = crossing.shape
    columns = padded - 2 * max_jump
    last = max_jump + columns
    blocked = np.int32(BLOCKED)
    row = totals[0]
    for x in range(padded):
        row[x] = crossing[first_row, x] if start < 0 or x == max_jump + start else blocked
    now = first_row
    for y in range(1, rows + 1):
        before, running = totals[y - 1], steps[now]
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
        now = now + 1 if now + 1 < rows else 0
        if y < rows:
            costs = crossing[now, max_jump:last]
            for x in range(columns):
                total = np.int32((best[x] if best[x] < blocked else blocked) + costs[x])
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
def _came_from(totals, steps, y, x, above, max_jump):
    """The column in row y - 1 from which the best path reaches column x of row y.

    Of several, that farthest to the left. The columns that were added on either side do not count:
    where all others are blocked, a path would leave the table through them.
    """
    best, origin = np.int32(2147483647), x
    last = totals.shape[1] - max_jump
    for j in range(max(x - max_jump, max_jump), min(x + max_jump + 1, last)):
        total = np.int32(totals[y - 1, j] + abs(np.int32(steps[above, x] - steps[above, j])))
        if total < best:
            best, origin = total, j
    return origin


@subroutine
def closed_path(
    totals: NDArray[np.int32],
    steps: NDArray[np.int32],
    max_jump: int,
    first_row: int,
    start: int,
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
    max_jump, first_row, start : int
        As T was filled.
    path : (H,) int32
        Receives the path: a column of 0 to W - 1 for every row.
    ends, columns_now : (W + 1,) int32
        Room to compute in.

    Returns
    -------
    int
        What the path costs; BLOCKED // 2 or more if every closed path is blocked.
    """
    rows, padded = steps.shape
    columns = padded - 2 * max_jump
    if start >= 0:
        best_end = start
    else:
        groups = columns
        for i in range(columns):
            ends[i], columns_now[i] = i, i + max_jump
        ends[groups] = columns
        for y in range(rows, 0, -1):
            above = first_row + y - 1
            above = above - rows if above >= rows else above
            kept, last = 0, -1
            for group in range(groups):
                origin = _came_from(totals, steps, y, columns_now[group], above, max_jump)
                if origin != last:
                    ends[kept], columns_now[kept] = ends[group], origin
                    kept += 1
                    last = origin
            groups = kept
            ends[groups] = columns
        best_end, best = -1, np.int32(2147483647)
        for group in range(groups):
            origin = columns_now[group] - max_jump
            closes = ends[group] <= origin < ends[group + 1]
            if closes and totals[rows, origin + max_jump] < best:
                best_end, best = origin, totals[rows, origin + max_jump]
    x = best_end + max_jump
    for y in range(rows, 0, -1):
        above = first_row + y - 1
        above = above - rows if above >= rows else above
        x = _came_from(totals, steps, y, x, above, max_jump)
        path[above] = x - max_jump
    return totals[rows, best_end + max_jump]
