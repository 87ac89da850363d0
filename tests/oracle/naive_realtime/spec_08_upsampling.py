"""8. From level to level."""

import numpy as np

from .spec_01_names import clamped, into_range, ranges


def upsampled_nnf(coarse, grid, source, width, spacing):
    """Give the NNF of the next finer level."""
    nnf, bounds = np.zeros((*grid, 2), int), ranges(source, width)
    for a, b in np.ndindex(grid):
        p, q = a // 2, b // 2
        y, x = coarse[p, q].tolist()
        match = 2 * y + spacing * (a - 2 * p), 2 * x + spacing * (b - 2 * q)
        nnf[a, b] = into_range(match, bounds)
    return nnf


def upsampled_picture(coarse, size):
    """Give B' of the next finer level."""
    picture = np.zeros((*size, 3), int)
    for y, x in np.ndindex(size):
        p, q = y // 2, x // 2
        v = p + 1 if y % 2 else p - 1
        u = q + 1 if x % 2 else q - 1
        beside = clamped(coarse, p, u) + clamped(coarse, v, q)
        total = 9 * clamped(coarse, p, q) + 3 * beside + clamped(coarse, v, u)
        picture[y, x] = (total + 8) >> 4
    return picture


def stage_upsample_nnf(p, a):
    """Do stage upsample_nnf."""
    grid, source = (p["rows"], p["columns"]), (p["source_height"], p["source_width"])
    return {"nnf": upsampled_nnf(a["nnf"], grid, source, p["patch_width"], p["spacing"])}


def stage_upsample_picture(p, a):
    """Do stage upsample_picture."""
    return {"picture": upsampled_picture(a["picture"], (p["height"], p["width"]))}


STAGES = {"upsample_nnf": stage_upsample_nnf, "upsample_picture": stage_upsample_picture}
