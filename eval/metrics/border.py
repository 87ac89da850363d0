"""Whether a texture tiles: what happens where its last column meets its first."""

import numpy as np

from eval.number import Number
from eval.textures import Texture

NUMBERS = {"border": Number("border", "{:.2f}")}

DEFINITION = """\
- **border**: mean step from the last row and column to the first, over the mean step between
  neighbours inside; near 1 the texture tiles, beyond 0.5 to 1.5 a border shows."""


def measure(scene, outcome):
    """The border of a texture."""
    return {"border": border(outcome.image)} if isinstance(scene, Texture) else {}


def border(image):
    """The step across the wrap over the step inside.

    Parameters
    ----------
    image : (H, W, c) uint8

    Returns
    -------
    float
        1 for a picture of a single colour, which tiles.
    """
    image = image.astype(float)
    inside = sum(np.abs(np.diff(image, axis=axis)).mean() for axis in (0, 1))
    across = np.abs(image[0] - image[-1]).mean() + np.abs(image[:, 0] - image[:, -1]).mean()
    return float(across / inside) if inside else 1.0
