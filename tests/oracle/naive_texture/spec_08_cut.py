"""8. The best closed cut."""

import numpy as np

from .spec_01_names import BLOCKED


def fill(crossing, steps, jump, arrivals):
    """Fill T, and from where the path comes to each of its entries."""
    rows, columns = crossing.shape
    totals = np.zeros((rows + 1, columns), int)
    origins = np.zeros((rows + 1, columns), int)
    for x in range(columns):
        totals[0, x] = min(int(arrivals[x]) + int(crossing[0, x]), BLOCKED)
    for y in range(1, rows + 1):
        sums = steps[y - 1]
        for x in range(columns):
            reached = range(max(x - jump, 0), min(x + jump, columns - 1) + 1)
            ways = [(totals[y - 1, j] + abs(sums[x] - sums[j]), j) for j in reached]
            total, origins[y, x] = min(ways)
            own = int(crossing[y, x]) if y < rows else 0
            totals[y, x] = min(total + own, BLOCKED)
    return totals, origins


def follow(origins, end):
    """Follow a path up; its column in every row of T."""
    path = [end]
    for y in range(len(origins) - 1, 0, -1):
        path.insert(0, origins[y, path[0]])
    return path


def best_closed(crossing, steps, jump, arrivals):
    """Find the best closed path."""
    columns = crossing.shape[1]
    totals, origins = fill(crossing, steps, jump, arrivals)

    def cost(x):
        blocked = totals[-1, x] >= BLOCKED // 2
        return int(totals[-1, x] if blocked else totals[-1, x] - arrivals[x])

    closed = [x for x in range(columns) if follow(origins, x)[0] == x]
    best = min(closed, key=cost)
    return totals, np.array(follow(origins, best)[:-1]), cost(best)


def closed_cut(crossing, steps, jump, second_pass):
    """Find the best closed cut, in one pass or two."""
    totals, path, cost = best_closed(crossing, steps, jump, [0] * crossing.shape[1])
    if second_pass:
        ends = totals[-1].tolist()
        arrivals = [min(end - min(ends), BLOCKED) for end in ends]
        _, path, cost = best_closed(crossing, steps, jump, arrivals)
        smallest = int(crossing[:, 0].sum())
        if smallest < cost:
            path, cost = np.zeros(len(path), int), smallest
    return path, cost


def stage_cut(p, a):
    """Do stage cut."""
    tables = zip(a["crossing"], a["steps"], a["arrivals"], strict=True)
    found = [best_closed(c, s, p["max_jump"], arrivals) for c, s, arrivals in tables]
    return {name: [one[k] for one in found] for k, name in enumerate(("totals", "paths", "costs"))}


def stage_closed_cut(p, a):
    """Do stage closed_cut."""
    tables = zip(a["crossing"], a["steps"], strict=True)
    found = [closed_cut(c, s, p["max_jump"], p["second_pass"]) for c, s in tables]
    return {"paths": [path for path, _ in found], "costs": [cost for _, cost in found]}


STAGES = {"cut": stage_cut, "closed_cut": stage_closed_cut}
