"""12. An iteration, and a run."""

import numpy as np

from .spec_01_names import BLOCKED, reach
from .spec_03_exemplars import centres_of, colours_of, numbered, valid_of
from .spec_04_random_numbers import grid, white_noise
from .spec_05_seams import seams
from .spec_06_candidates import candidate
from .spec_07_costs import Patch
from .spec_08_cut import closed_cut
from .spec_09_alignment import alignment
from .spec_10_raster import raster
from .spec_11_change import change, cost_of, inner, written

UNTRIED, REJECTED, ACCEPTED, DEFORMED = range(4)


def nothing_to_do(p, a, y, x):
    """Tell whether a cell is not tried."""
    patch, pixels = Patch(p, a, 0, y, x), reach(p["radius"])
    if all(patch.locked(*pixel) for pixel in pixels):
        return True
    costs = sum(a[name][patch.pixel(*pixel)] for pixel in pixels for name in ("seams_x", "seams_y"))
    return p["guide_weight"] == 0 and p["predicate"] != "none" and costs == 0


def across(steps, path):
    """Cost of the steps of a cut along rays."""
    after = [*path[1:], path[0]]
    return sum(abs(int(steps[y, after[y]] - steps[y, path[y]])) for y in range(len(path)))


def fit(p, a, centres, cell, y, x):
    """Judge a patch for a cell: its outcome, its change, and what it writes."""
    if nothing_to_do(p, a, y, x):
        return UNTRIED, 0, None
    best = None
    for attempt in range(p["tries"]):
        source = candidate(p, a, centres, cell, attempt, y, x)
        patch = Patch(p, a, source, y, x)
        saved, crossing, steps = patch.tables()
        path, cost = closed_cut(crossing, steps, p["max_jump"], p["second_pass"])
        if cost >= BLOCKED // 2:
            continue
        if best is None or cost << patch.halved < best[0]:
            hides = sum(int(saved[row, path[row]]) for row in range(len(path)))
            best = cost << patch.halved, patch, path, hides, across(steps, path)
    if best is None or (p["predicate"] == "before" and best[0] >= 0):
        return REJECTED, 0, None
    cost, patch, path, hides, stepped = best
    outcome, pixels = ACCEPTED, raster(patch, path, None)
    changed = change(p, a, pixels, y, x)
    if p["max_shift"] > 0:
        _, shifts, along = alignment(patch, path)
        bent = raster(patch, path, shifts)
        bent_change = change(p, a, bent, y, x)
        estimate = stepped + along + (inner(p, a, bent) >> patch.halved) - hides
        if bent_change < changed and (p["predicate"] != "after" or estimate < 0):
            outcome, pixels, changed = DEFORMED, bent, bent_change
    if p["predicate"] == "after" and outcome == ACCEPTED and cost >= 0:
        return REJECTED, 0, None
    if p["predicate"] == "exact" and changed >= 0:
        return REJECTED, 0, None
    return outcome, changed, pixels


def count_seams(p, a):
    """Count the seams of S anew."""
    given = a["addresses"], a["colours"], a["valid"].shape[1], p["eta"], p["exponent"]
    a["seams_x"], a["seams_y"] = seams(*given)


def iterate(p, a):
    """Do an iteration; what became of the cells, and their changes."""
    cells = grid(*a["addresses"].shape, p["radius"], p["seed"], p["iteration"])
    centres = centres_of(a["valid"], p["radius"])
    count_seams(p, a)
    judged = [fit(p, a, centres, cell, y, x) for cell, (y, x) in enumerate(cells)]
    for (y, x), (_, _, pixels) in zip(cells, judged, strict=True):
        if pixels is not None:
            a["addresses"] = written(p, a["addresses"], pixels, y, x)
    count_seams(p, a)
    return [outcome for outcome, _, _ in judged], [changed for _, changed, _ in judged]


def stage_iteration(p, a):
    """Do stage iteration."""
    outcomes, changes = iterate(p, a)
    found = {name: a[name] for name in ("addresses", "seams_x", "seams_y")}
    return found | {"outcomes": outcomes, "changes": changes}


def stage_run(p, a):
    """Do stage run."""
    images, guides = numbered(a, "image"), numbered(a, "source_guide")
    radius, fractions = p["radius"], p["fractions"]
    a["colours"] = colours_of(images, radius, fractions)
    a["valid"] = valid_of(images, numbered(a, "known"), radius)
    if guides:
        a["guide_colours"] = colours_of(guides, radius, fractions)
        target = a["target_guide"]
        a["guide"] = colours_of([target], radius, False).reshape(
            target.shape[0] + 2 * (radius - radius // 2 + 4), -1
        )
        inside = radius - radius // 2 + 4
        a["guide"] = a["guide"][inside:-inside, inside:-inside]
    pixels = np.flatnonzero(a["valid"])
    a["addresses"] = white_noise(pixels, p["height"], p["width"], p["seed"])
    totals = [cost_of(p, a, a["addresses"])]
    for iteration in range(p["iterations"]):
        _, changes = iterate(p | {"iteration": iteration}, a)
        totals.append(totals[-1] + sum(changes))
    return {"addresses": a["addresses"], "totals": totals}


STAGES = {"iteration": stage_iteration, "run": stage_run}
