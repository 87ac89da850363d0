"""10. Dense finish."""

import numpy as np

from .spec_01_names import clamped, into_range, ranges
from .spec_05_energy import Energy
from .spec_06_search import WORST
from .spec_07_blend import blend, covering


def candidates(p, nnf, y, x, bounds):
    """List the matches that a pixel may take."""
    spacing, width = p["spacing"], p["patch_width"]
    found = []
    for a in dict.fromkeys(covering(y, spacing, width, nnf.shape[0])):
        for b in dict.fromkeys(covering(x, spacing, width, nnf.shape[1])):
            down, right = nnf[a, b].tolist()
            found.append(into_range((down + y - a * spacing, right + x - b * spacing), bounds))
    return found


def dense_nnf(p, a):
    """Give every pixel a match."""
    energy, nnf = Energy(p | {"spacing": 1}, a), a["nnf"]
    bounds = ranges(a["source_guides"].shape[:2], p["patch_width"])
    size = a["target_guides"].shape[:2]
    dense = np.zeros((*size, 2), int)
    for pixel in np.ndindex(size):

        def is_barred(centre, pixel=pixel):
            return "target_labels" in a and a["source_labels"][centre] != a["target_labels"][pixel]

        match, *others = candidates(p, nnf, *pixel, bounds)
        best = WORST if is_barred(match) else energy.of(pixel, match)
        for other in others:
            if other != match and not is_barred(other):
                found = energy.of(pixel, other)
                if found < best:
                    best, match = found, other
        dense[pixel] = match
    return dense


def vote(style, dense, width):
    """Give the mean of all patches over each pixel."""
    height, columns = dense.shape[:2]
    radius = width // 2
    picture = np.zeros((height, columns, 3), int)
    for y, x in np.ndindex(height, columns):
        total, number = 0, 0
        for j in range(max(y - radius, 0), min(y + radius, height - 1) + 1):
            for i in range(max(x - radius, 0), min(x + radius, columns - 1) + 1):
                down, right = dense[j, i].tolist()
                total = total + clamped(style, down + y - j, right + x - i)
                number += 1
        picture[y, x] = (total + number // 2) // number
    return picture


def stage_dense_nnf(p, a):
    """Do stage dense_nnf."""
    return {"dense": dense_nnf(p, a)}


def stage_vote(p, a):
    """Do stage vote."""
    return {"picture": vote(a["source_style"], a["dense"], p["patch_width"])}


def stage_finish(p, a):
    """Do stage finish."""
    size = a["target_guides"].shape[:2]
    picture = blend(a["source_style"], a["nnf"], p["patch_width"], p["spacing"], size)
    dense = dense_nnf(p | {"mu": p["mu"][0]}, a | {"target_style": picture})
    return {"dense": dense, "picture": vote(a["source_style"], dense, p["patch_width"])}


STAGES = {"dense_nnf": stage_dense_nnf, "vote": stage_vote, "finish": stage_finish}
