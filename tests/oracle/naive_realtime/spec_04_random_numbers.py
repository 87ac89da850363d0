"""4. Random numbers."""

import numpy as np

from .spec_01_names import ranges

WORD = 0xFFFFFFFF
RANDOM_NNF, SEARCH = 32, 33


def philox(c0, c1, c2, c3, k0, k1):
    """Compute Philox4x32-10."""
    for _ in range(10):
        h0, l0 = divmod(0xD2511F53 * c0, 2**32)
        h1, l1 = divmod(0xCD9E8D57 * c2, 2**32)
        c0, c1, c2, c3 = h1 ^ c1 ^ k0, l1, h0 ^ c3 ^ k1, l0
        k0, k1 = (k0 + 0x9E3779B9) & WORD, (k1 + 0xBB67AE85) & WORD
    return c0, c1, c2, c3


def draw(seed, purpose, level, iteration, half, position, number):
    """Draw four words."""
    third, fourth = iteration << 16 | half, purpose << 16 | level
    return philox(position, number, third, fourth, seed & WORD, seed >> 32)


def place(word, bounds):
    """Give a random (y, x) within bounds."""
    (top, bottom), (left, right) = bounds
    y = top + (((word >> 16) * (bottom - top + 1)) >> 16)
    x = left + (((word % 65536) * (right - left + 1)) >> 16)
    return y, x


def random_nnf(grid, source, width, seed, level):
    """Give an NNF at random."""
    nnf, bounds = np.zeros((*grid, 2), int), ranges(source, width)
    for a, b in np.ndindex(grid):
        word = draw(seed, RANDOM_NNF, level, 0, 0, a * grid[1] + b, 0)[0]
        nnf[a, b] = place(word, bounds)
    return nnf


def stage_random_nnf(p, a):
    """Do stage random_nnf."""
    grid, source = (p["rows"], p["columns"]), (p["source_height"], p["source_width"])
    return {"nnf": random_nnf(grid, source, p["patch_width"], p["seed"], p["level"])}


STAGES = {"random_nnf": stage_random_nnf}
