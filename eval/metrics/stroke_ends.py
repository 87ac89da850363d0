"""Whether drawn strokes are as long as those of the style."""

import numpy as np
from scipy.ndimage import convolve
from skimage.morphology import skeletonize

from eval.metrics.gradient import luma
from eval.number import Number
from eval.scenes import Scene

NUMBERS = {"stroke_ends": Number("ends of strokes", "{:.2f}")}

DEFINITION = """\
- **ends of strokes**: ends for every pixel along dark strokes, over the same in the style; 1 means
  strokes as long as the style's, 2 means pieces half as long. Dark is what is nearer to the darkest
  of the style than to its paper. It tells of line art alone."""


def measure(scene, outcome):
    """The number of a single picture, if it and its style have strokes."""
    if not isinstance(scene, Scene):
        return {}
    ours, theirs = (
        ends_by_length(is_dark(image, scene.style)) for image in (outcome.image, scene.style)
    )
    return {"stroke_ends": ours / theirs} if theirs and ours is not None else {}


def is_dark(image, style):
    """What is nearer to the darkest of the style than to its paper, (H, W) bool."""
    darkest, paper = np.percentile(luma(style), (2, 98))
    return luma(image) < (darkest + paper) / 2


def ends_by_length(ink):
    """How many ends strokes have for every pixel of their middle lines.

    Parameters
    ----------
    ink : (H, W) bool

    Returns
    -------
    float or None
        None without ink.
    """
    lines = skeletonize(ink)
    return float(ends_of(lines).sum() / lines.sum()) if lines.any() else None


def ends_of(lines):
    """The ends of lines of one pixel's width, (H, W) bool."""
    neighbours = convolve(lines.astype(int), np.ones((3, 3), int), mode="constant") - 1
    return lines & (neighbours <= 1)
