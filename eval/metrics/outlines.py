"""Whether outlines are still drawn beside the silhouettes that they leave."""

import numpy as np
from scipy.ndimage import minimum_filter

from eval.frame_sets import FrameSet
from eval.metrics.gradient import luma
from eval.number import Number

NUMBERS = {"outlines": Number("dark outlines", "{:.1%}")}

DEFINITION = """\
- **dark outlines**: the share of dark pixels in a band beside silhouettes, on the farther side,
  where strokes leave the geometry. The band is 3 pixels wide where a frame has 228 rows, and more
  where it has more. Dark is what is nearer to the darkest of the style than to its paper."""

WIDTH_OF_ROWS = 3 / 228
"""Width of the band over the height of a frame."""

STEP = 1.05
"""How many times as far a thing must lie, for the silhouette of what is before it to count."""


def measure(scene, outcome):
    """The share of dark pixels in all frames, if ids and depth are known."""
    if not isinstance(scene, FrameSet) or scene.ids is None or scene.depths is None:
        return {}
    bands = np.stack([band(ids, depth) for ids, depth in zip(scene.ids, scene.depths, strict=True)])
    return {"outlines": dark_share(outcome.image, bands, scene.style)} if bands.any() else {}


def band(ids, depth):
    """Pixels beside something nearer that is another thing.

    Parameters
    ----------
    ids : (H, W, n) uint8
        A colour for each thing.
    depth : (H, W) float32
        Farther is larger, 0 where nothing is.

    Returns
    -------
    (H, W) bool
    """
    radius = max(1, round(WIDTH_OF_ROWS * depth.shape[0]))
    reach = np.hypot(*np.mgrid[-radius : radius + 1, -radius : radius + 1]) <= radius
    colours, parts = np.unique(ids.reshape(-1, ids.shape[-1]), axis=0, return_inverse=True)
    parts = parts.reshape(depth.shape)
    depth = np.where(depth > 0, depth, np.inf)
    found = np.zeros(depth.shape, np.bool_)
    for part in range(len(colours)):
        others = np.where(parts == part, np.inf, depth)
        beside = minimum_filter(others, footprint=reach, mode="nearest")
        found |= (parts == part) & (STEP * beside <= depth) & (beside < np.inf)
    return found


def dark_share(images, bands, style):
    """Which share of some pixels is dark.

    Parameters
    ----------
    images : (F, H, W, n) uint8
    bands : (F, H, W) bool
    style : (H_A, W_A, n) uint8

    Returns
    -------
    float
    """
    darkest, paper = np.percentile(luma(style), (2, 98))
    return float((luma(images)[bands] < (darkest + paper) / 2).mean())
