"""6. Votes and the limited search."""

import numpy as np


def around(pixel, radius, size):
    """List the pixels of the picture whose patches cover a pixel."""
    rows, columns = (
        range(max(at - radius, 0), min(at + radius + 1, side))
        for at, side in zip(pixel, size, strict=True)
    )
    return [(row, column) for row in rows for column in columns]


def voted(style, nnf, radius):
    """Make the picture."""
    size = nnf.shape[:2]
    picture = np.empty((*size, style.shape[2]), np.int64)
    for pixel in np.ndindex(size):
        covering = around(pixel, radius, size)
        total = sum(style[tuple(nnf[q] + pixel - np.array(q))] for q in covering)
        picture[pixel] = (2 * total + len(covering)) // (2 * len(covering))
    return picture


def searched(style, nnf, candidates, picture, radius):
    """Choose the best of all candidates."""
    found = nnf.copy()
    height, width = nnf.shape[:2]
    steps = range(-radius, radius + 1)
    for y, x in np.ndindex(height, width):
        best = None
        for centre in (nnf[y, x], *candidates[:, y, x]):
            if centre[0] < 0:
                continue
            error = 0
            for down in steps:
                for right in steps:
                    row = min(max(y + down, 0), height - 1)
                    column = min(max(x + right, 0), width - 1)
                    ours = style[centre[0] + down, centre[1] + right]
                    error += ((ours - picture[row, column]) ** 2).sum()
            if best is None or error < best:
                best, found[y, x] = error, centre
    return found


def stage_vote(p, a):
    """Do stage vote."""
    return {"picture": voted(a["style"], a["nnf"], p["patch_width"] // 2)}


def stage_search(p, a):
    """Do stage search."""
    radius = p["patch_width"] // 2
    return {"nnf": searched(a["style"], a["nnf"], a["candidates"], a["picture"], radius)}


STAGES = {"vote": stage_vote, "search": stage_search}
