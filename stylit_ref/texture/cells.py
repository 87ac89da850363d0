"""Where the patches of an iteration are placed: the centres of their cells (section 3)."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from stylit_ref.randomness.philox import FourWords, philox4x32, uniform_below

_DRAWS = 6
"""Draws for each cell that would fit, when cells are placed on some pixels alone."""


def largest_radius(size: tuple[int, int]) -> int:
    """The largest R of which one cell fits a texture of this height and width."""
    return max(1, min(size) // 2)


def grid_cells(size: tuple[int, int], radius: int, stream: FourWords) -> NDArray[np.int64]:
    """Centres (y, x) of a grid of cells over the whole texture, placed at random.

    Parameters
    ----------
    size : tuple of int
        Height and width of the texture.
    radius : int
    stream : tuple of 4 uint32

    Returns
    -------
    (n, 2) int64
        Neighbours are at least 2R apart.
    """
    height, width = size
    down, across = _fitting(size, radius)
    words = philox4x32(0, 0, *stream)
    first_y, first_x = uniform_below(words[0], height), uniform_below(words[1], width)
    y = (first_y + np.arange(down) * height // down) % height
    x = (first_x + np.arange(across) * width // across) % width
    return np.stack(np.meshgrid(y, x, indexing="ij"), axis=-1).reshape(-1, 2).astype(np.int64)


def cells_on(
    pixels: NDArray[np.int64],
    seams: Sequence[NDArray[np.int32]],
    radius: int,
    stream: FourWords,
) -> NDArray[np.int64]:
    """Centres (y, x) of cells on some pixels alone, drawn at random.

    What is locked needs no patch: a grid over a small hole would mostly miss it. In half of the
    iterations the pixels that are drawn are taken in the order of what their seams cost, after one
    of the worst of all, so that no noise waits long for a patch. (If always, the same few places
    would be tried again and again.) A pixel that lies closer than 2R to an earlier one, both in y
    and in x, is left out.

    Parameters
    ----------
    pixels : (m,) int64
        Numbers of the pixels, ``y * width + x``.
    seams : sequence of (H, W) int32
        What the edges of every pixel cost.
    radius, stream
        As of :func:`grid_cells`.

    Returns
    -------
    (n, 2) int64
        At least one, unless there are no pixels.
    """
    if not pixels.size:
        return np.empty((0, 2), np.int64)
    size = seams[0].shape
    down, across = _fitting(size, radius)
    most = min(down * across, pixels.size // (2 * radius) + 1)  # of them, a line has so many
    words = [philox4x32(k, 1, *stream) for k in range(_DRAWS * most)]
    drawn = pixels[[uniform_below(word[0], pixels.size) for word in words]]
    if words[0][1] & 1:
        costs = _costs(seams, pixels)
        worst = pixels[costs >= costs.max() / 2]
        drawn = drawn[np.argsort(-_costs(seams, drawn), kind="stable")]
        drawn[0] = worst[uniform_below(words[0][2], worst.size)]
    cells = np.empty((most, 2), np.int64)
    placed = 0
    for cell in np.stack(np.divmod(drawn, size[1]), axis=1):
        apart = np.abs(cells[:placed] - cell)
        apart = np.minimum(apart, np.array(size) - apart)
        if placed == 0 or (apart.max(axis=1) >= 2 * radius).all():
            cells[placed] = cell
            placed += 1
            if placed == len(cells):
                break
    return cells[:placed]


def _costs(seams, pixels):
    return sum(each.ravel()[pixels].astype(np.int64) for each in seams)


def _fitting(size, radius):
    height, width = size
    return max(1, height // (2 * radius)), max(1, width // (2 * radius))
