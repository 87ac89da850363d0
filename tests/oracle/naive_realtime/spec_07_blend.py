"""7. Blend."""

import numpy as np

from .spec_01_names import clamped


def covering(place, spacing, width, entries):
    """List the two rows, or columns, of entries that cover a row of pixels."""
    near, radius = place // spacing, width // 2
    found = []
    if place - near * spacing <= radius:
        found.append(near)
    if near + 1 < entries and (near + 1) * spacing - place <= radius:
        found.append(near + 1)
    found = found or [near]
    return found if len(found) == 2 else found * 2


def blend(style, nnf, width, spacing, size):
    """Give B'."""
    picture = np.zeros((*size, 3), int)
    for y, x in np.ndindex(size):
        total = 2
        for a in covering(y, spacing, width, nnf.shape[0]):
            for b in covering(x, spacing, width, nnf.shape[1]):
                down, right = nnf[a, b].tolist()
                total = total + clamped(style, down + y - a * spacing, right + x - b * spacing)
        picture[y, x] = total >> 2
    return picture


def stage_blend(p, a):
    """Do stage blend."""
    size = p["height"], p["width"]
    return {"picture": blend(a["source_style"], a["nnf"], p["patch_width"], p["spacing"], size)}


STAGES = {"blend": stage_blend}
