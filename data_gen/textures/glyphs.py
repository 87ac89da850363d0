"""Rows of invented letters on paper: strokes between the nine knots of a square."""

import numpy as np

from data_gen.textures.noise import picture, smooth_noise

CELL = 32
"""Side of the square of a letter, in pixels."""

_LETTERS = 14
_PAPER, _INK = (226, 214, 188), (44, 36, 52)
_THICKNESS = 1.6


def glyphs(size, seed):
    """Make the exemplar; returns (size, size, 3) uint8."""
    rng = np.random.default_rng(seed)
    alphabet = [_letter(rng) for _ in range(_LETTERS)]
    cells = -(-size // CELL)
    chosen = rng.integers(_LETTERS, size=(cells, cells))
    ink = np.block([[alphabet[letter] for letter in row] for row in chosen])[:size, :size, None]
    colours = np.array(_PAPER) + 14 * smooth_noise(rng, size, 2.5) + 10 * smooth_noise(rng, size, 0)
    return picture((1 - ink) * colours + ink * np.array(_INK))


def _letter(rng):
    """How much ink covers each pixel of a cell: a stem and three more strokes."""
    y, x = np.mgrid[:CELL, :CELL] + 0.5
    knots = np.stack(np.meshgrid((7, 16, 25), (9, 16, 23), indexing="ij"), -1).reshape(-1, 2)
    column = rng.integers(3)
    strokes = [(column, column + 6)]
    while len(strokes) < 4:
        start, end = rng.choice(9, 2, replace=False)
        strokes.append((start, end))
    distance = np.full((CELL, CELL), np.inf)
    for start, end in strokes:
        (top, left), (bottom, right) = knots[start], knots[end]
        down, along = bottom - top, right - left
        share = ((y - top) * down + (x - left) * along) / (down**2 + along**2)
        share = share.clip(0, 1)
        distance = np.minimum(distance, np.hypot(y - top - share * down, x - left - share * along))
    return (_THICKNESS + 0.5 - distance).clip(0, 1)
