"""Whether a texture repeats itself: the same pixels again, always as far away."""

import numpy as np

from eval.number import Number
from eval.textures import Texture

MOST_USES = 64

NUMBERS = {"repetition": Number("repetition", "{:.1%}")}

DEFINITION = """\
- **repetition**: the largest share of a texture that shows the same pixels of the exemplar again
  after one shift: one block laid side by side has 100 %. Structures that repeat in the exemplar do
  not count."""


def measure(scene, outcome):
    """The repetition, if the method tells its coordinates."""
    if not isinstance(scene, Texture) or outcome.coordinates is None:
        return {}
    return {"repetition": repetition(outcome.coordinates)}


def repetition(coordinates):
    """The largest share of pixels that one shift takes to pixels with the same source.

    Parameters
    ----------
    coordinates : (h, w, 3) int32
        Exemplar, y and x in quarters of a pixel; the nearest whole pixels count.

    Returns
    -------
    float
    """
    height, width = coordinates.shape[:2]
    pixels = (coordinates.astype(np.int64) + np.array([0, 2, 2])) // np.array([1, 4, 4])
    source = (pixels[..., 0] << 40) + (pixels[..., 1] << 20) + pixels[..., 2]
    order = np.argsort(source, axis=None, kind="stable")
    sorted_source = source.ravel()[order]
    shares = np.zeros(height * width, np.int64)
    for lag in range(1, MOST_USES):
        same = sorted_source[lag:] == sorted_source[:-lag]
        if not same.any():
            break
        first_y, first_x = np.divmod(order[:-lag][same], width)
        second_y, second_x = np.divmod(order[lag:][same], width)
        for sign in (1, -1):
            down = sign * (second_y - first_y) % height
            along = sign * (second_x - first_x) % width
            shares += np.bincount(down * width + along, minlength=height * width)
    return float(shares.max() / (height * width))
