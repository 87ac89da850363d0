"""Exemplars for texture synthesis, made by code from a seed: the same bytes again.

Most are stochastic or have a regular structure; the door is global, which patches cannot keep.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from data_gen.textures.bricks import BRICK, bricks
from data_gen.textures.canes import canes
from data_gen.textures.door import door
from data_gen.textures.flowers import flowers
from data_gen.textures.glyphs import CELL, glyphs
from data_gen.textures.marble import marble
from data_gen.textures.pebbles import pebbles


class Recipe(NamedTuple):
    """How an exemplar is made.

    Attributes
    ----------
    make : callable
        Called with the side in pixels and the seed.
    seed : int
        Of the exemplar that reports show.
    period : tuple of 2 int, optional
        Pixels down and along after which the structure repeats; tones and noise do not.
    """

    make: Callable[[int, int], np.ndarray]
    seed: int
    period: tuple[int, int] | None = None


TEXTURES = {
    "bricks": Recipe(bricks, 0, (2 * BRICK[0], BRICK[1])),
    "canes": Recipe(canes, 1),
    "flowers": Recipe(flowers, 2),
    "pebbles": Recipe(pebbles, 3),
    "glyphs": Recipe(glyphs, 4, (CELL, CELL)),
    "marble": Recipe(marble, 5),
    "door": Recipe(door, 6),
}
"""All exemplars, by name."""

SIZE = 256


def make_texture(name: str, size: int = SIZE, seed: int | None = None) -> np.ndarray:
    """Make an exemplar.

    Parameters
    ----------
    name : str
        One of :data:`TEXTURES`.
    size : int
        Its side in pixels.
    seed : int, optional
        By default that of the recipe.

    Returns
    -------
    (size, size, 3) uint8

    Raises
    ------
    KeyError
        If there is no such exemplar.
    """
    recipe = TEXTURES[name]
    return recipe.make(size, recipe.seed if seed is None else seed)
