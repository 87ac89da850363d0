"""Whether strokes keep their direction and length: Heidrich 2017, 6.2.2 and Figures 24b and 25."""

import numpy as np
from skimage.feature import structure_tensor

from eval.number import Number

FINE, COARSE = 1.5, 4.0
"""Widths in pixels over which a direction is told: of a stroke's place, and of a hatched area."""

NUMBERS = {
    "bent": Number("bent strokes", "{:.1f}°"),
    "hatching": Number("hatching kept", "{:.3f}"),
}

DEFINITION = """\
- **bent strokes**: mean angle between the direction of the output and that of the style where it
  was taken from, weighted by how clear the style's direction is; 45° is chance. **hatching kept**:
  how much strokes agree in direction within 4 pixels, over the same in the style where it was taken
  from; below 1, strokes are broken."""


def measure(scene, outcome):
    """Both numbers of a stylization whose NNF is known."""
    if outcome.nnf is None:
        return {}
    return {
        "bent": bent_strokes(outcome.image, scene.style, outcome.nnf),
        "hatching": hatching_kept(outcome.image, scene.style, outcome.nnf),
    }


def bent_strokes(image, style, nnf):
    """Mean angle in degrees between strokes and where they come from.

    Parameters
    ----------
    image : (H_B, W_B, n) uint8
    style : (H_A, W_A, n) uint8
    nnf : (H_B, W_B, 2) int32

    Returns
    -------
    float
        0 to 90; 0 for a style without strokes.
    """
    ours, theirs = _double_angle(image, FINE), _double_angle(style, FINE)[nnf[..., 0], nnf[..., 1]]
    weight = np.abs(theirs)
    if not weight.any():
        return 0.0
    double = np.abs((np.angle(ours) - np.angle(theirs) + np.pi) % (2 * np.pi) - np.pi)
    angle = np.degrees(double) / 2
    return float((angle * weight).sum() / weight.sum())


def hatching_kept(image, style, nnf):
    """Agreement of strokes in direction, over that in the style where they come from.

    Parameters
    ----------
    image : (H_B, W_B, n) uint8
    style : (H_A, W_A, n) uint8
    nnf : (H_B, W_B, 2) int32

    Returns
    -------
    float
        1 for a copy, and for a style without strokes.
    """
    theirs, whole = (part[nnf[..., 0], nnf[..., 1]].sum() for part in _agreement(style))
    ours, all_ours = (part.sum() for part in _agreement(image))
    if not (theirs and whole and all_ours):
        return 1.0
    return float((ours / all_ours) / (theirs / whole))


def _tensor(image, width):
    grey = np.atleast_3d(image).astype(float).mean(axis=2)
    return structure_tensor(grey, sigma=width, mode="nearest", order="rc")


def _double_angle(image, width):
    """(H, W) complex: twice the direction's angle, as long as the direction is strong and clear."""
    down, mixed, along = _tensor(image, width)
    return (down - along) + 2j * mixed


def _agreement(image):
    """What of the gradients agrees within the width, and all of them, (H, W) each."""
    down, _, along = _tensor(image, COARSE)
    return np.abs(_double_angle(image, COARSE)), down + along
