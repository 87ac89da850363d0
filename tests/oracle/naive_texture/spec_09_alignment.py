"""9. Alignment."""

import numpy as np

from .spec_01_names import offset_of, r10
from .spec_07_costs import Patch
from .spec_08_cut import closed_cut


def point(patch, radius, angle):
    """Give the address of a point."""
    cosine, sine = patch.a["cosine"], patch.a["sine"]
    row, share = angle >> 8, angle % 256
    c, s = (int(t[row]) + ((int(t[row + 1] - t[row]) * share) >> 8) for t in (cosine, sine))
    qy, qx = (radius * s + 2**15) >> 16, (radius * c + 2**15) >> 16
    if patch.p["fractions"]:
        plane = patch.a["valid"].size
        phase = 4 * (qy % 4) + qx % 4
        return phase * plane + patch.new(qy >> 2, qx >> 2)
    return patch.new((qy + 2) >> 2, (qx + 2) >> 2)


def old_pixel(patch, y, cut):
    """Give the old pixel beside the cut in a row, the step to it, and whether both are locked."""
    a, radius = patch.a, patch.p["radius"]
    if a["cut_cosine"][y] >= a["cut_sine"][y]:
        dy, dx = offset_of(int(a["cut_x"][y, cut]), radius)
        free = patch.locked(dy, dx) and patch.locked(dy, dx + 1)
        return (dy, dx + 1, 1, free) if a["cosine"][y] > 0 else (dy, dx, -1, free)
    dy, dx = offset_of(int(a["cut_y"][y, cut]), radius)
    free = patch.locked(dy, dx) and patch.locked(dy + 1, dx)
    return (dy + 1, dx, patch.stride, free) if a["sine"][y] > 0 else (dy, dx, -patch.stride, free)


def alignment(patch, path):
    """Find the costs of all shifts, the best shifts and what they cost."""
    p, a, rows = patch.p, patch.a, len(path)
    most = p["max_shift"]
    costs = np.zeros((rows, 2 * most + 1), int)
    for y in range(rows):
        dy, dx, step, free = old_pixel(patch, y, path[y])
        weight = r10(int(a["cut_weight"][path[y]]) * int(a["cut_cosine"][y] + a["cut_sine"][y]))
        for k in range(-most, most + 1):
            there = (y + k) % rows
            radius = max(int(a["border"][path[there] + 1]) - 128, 0)
            cost = patch.seam(point(patch, radius, 256 * there), patch.old(dy, dx), step)
            costs[y, k + most] = (
                0 if free else r10(min(cost >> patch.halved, p["new_limit"]) * weight)
            )
    steps = np.tile(np.arange(2 * most + 1) * p["penalty"], (rows, 1))
    shifted, cost = closed_cut(costs, steps, 1, False)
    return costs, shifted - most, cost


def stage_alignment(p, a):
    """Do stage alignment."""
    patch = Patch(p, a, p["source"], p["y"], p["x"])
    patch.halved = p["halved"]
    costs, shifts, cost = alignment(patch, a["path"].tolist())
    return {"costs": costs, "shifts": shifts, "cost": cost}


STAGES = {"alignment": stage_alignment}
