"""5. Shifting."""

from fractions import Fraction
from math import floor

import numpy as np


def half_up(coordinate, component):
    """Round a coordinate in another view half up."""
    return floor(coordinate + Fraction(float(component)) + Fraction(1, 2))


def shifted(a, k, y, x):
    """Find a pixel's place in a view, and whether it is masked there."""
    height, width = a["labels"].shape
    taken = tuple(a["beside"][y, x])
    right, down = a["motion"][k][taken]
    if not (abs(right) <= width and abs(down) <= height):
        return (y, x), True
    row, column = half_up(y, down), half_up(x, right)
    held = min(max(row, 0), height - 1), min(max(column, 0), width - 1)
    is_shown = held == (row, column) and a["view_labels"][k][held] == a["labels"][taken]
    return held, not is_shown


def all_shifted(a):
    """Shift every pixel into every view."""
    views = a["motion"].shape[:3]
    places, masked = np.empty((*views, 2), np.int64), np.empty(views, np.bool_)
    for k, y, x in np.ndindex(views):
        places[k, y, x], masked[k, y, x] = shifted(a, k, y, x)
    return places, masked


def fetched(nnfs, places, masked):
    """Give the candidates of every view, and the NNF that is chosen."""
    candidates = np.full(places.shape, -1)
    nnf = np.empty(places.shape[1:], np.int64)
    for y, x in np.ndindex(nnf.shape[:2]):
        for k in range(len(places)):
            if not masked[k, y, x]:
                candidates[k, y, x] = nnfs[k][tuple(places[k, y, x])]
        shown = [k for k in range(len(places)) if not masked[k, y, x]]
        first = shown[0] if shown else 0
        nnf[y, x] = nnfs[first][tuple(places[first, y, x])]
    return candidates, nnf


def stage_shift(p, a):
    """Do stage shift."""
    places, masked = all_shifted(a)
    return {"places": places, "masked": masked}


def stage_fetch(p, a):
    """Do stage fetch."""
    candidates, nnf = fetched(a["nnfs"], a["places"], a["masked"])
    return {"candidates": candidates, "nnf": nnf}


STAGES = {"shift": stage_shift, "fetch": stage_fetch}
