"""How a picture copies its style: artefacts of Heidrich 2017, Figures 24d and 25e, j, l, m."""

import numpy as np

from eval.number import Number

MARGIN = 2
"""Pixels of the style's border: the radius of a patch."""

FAR = 8
"""Pixels from the target's own border, where the style's has no business."""

SMALL = 2
"""Largest step, in pixels, that stretches; a larger one is a seam."""

NUMBERS = {
    "style_border": Number("style's border", "{:.2f}"),
    "stretched": Number("stretched", "{:.2%}"),
}

DEFINITION = """\
- **style's border**: pixels at least 8 from the target's border that are taken from the outer 2
  pixels of the style, over what even use of the style would take from there; beyond 2 it shows.
  **stretched**: neighbouring pixels whose sources are 1 or 2 pixels from being neighbours, so that
  a structure is drawn out or squeezed; a larger step is a seam."""


def measure(scene, outcome):
    """Both numbers of a stylization whose NNF is known."""
    if outcome.nnf is None:
        return {}
    return {
        "style_border": style_border(outcome.nnf, scene.style.shape[:2]),
        "stretched": stretched(outcome.nnf),
    }


def style_border(nnf, size):
    """Use of the style's border inside the target, over even use.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
    size : tuple of int
        Height and width of the style.

    Returns
    -------
    float
        0 if the target has no inside.
    """
    inside = nnf[FAR:-FAR, FAR:-FAR]
    if not inside.size:
        return 0.0
    last = np.array(size) - 1
    at_border = (np.minimum(inside, last - inside) < MARGIN).any(axis=2)
    within = np.prod([max(side - 2 * MARGIN, 0) for side in size])
    return float(at_border.mean() / (1 - within / np.prod(size)))


def stretched(nnf):
    """Share of neighbouring pixels whose sources nearly continue each other.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32

    Returns
    -------
    float
        Over pairs to the right and below; 0 for a single pixel.
    """
    right = nnf[:, 1:] - nnf[:, :-1] - (0, 1)
    below = nnf[1:] - nnf[:-1] - (1, 0)
    steps = np.abs(np.concatenate([right.reshape(-1, 2), below.reshape(-1, 2)])).max(axis=1)
    return float(((steps > 0) & (steps <= SMALL)).mean()) if steps.size else 0.0
