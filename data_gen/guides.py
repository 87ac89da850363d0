"""8-bit guides from the layers of a view.

====================  ====================================================
light passes          scene-linear, sRGB curve, clipped at 1
masks, FRESNEL,       values in [0, 1] as they are
WIREFRAME
NORMAL                (n + 1) / 2
DEPTH                 nearest 1, farthest 0, between the limits of the stage
POSITION              each axis between the limits of the stage
====================  ====================================================

All round half up. ``stylit-ref`` applies the sRGB curve to every layer of an EXR that it is
given, so it sees the same values for the light passes only.
"""

import numpy as np

LIGHT_PASSES = ("FULL", "LDE", "LSE", "LDDE", "LD12E")
DEPTHS = (0.0, 30.0)
"""Limits of the stage along the view, in its units."""
CORNERS = ((-6.0, 0.0, -6.0), (6.0, 6.0, 6.0))
"""Limits of the stage along its axes."""


def guide(name, layer):
    """A layer as an 8-bit image.

    Parameters
    ----------
    name : str
    layer : (H, W, n) float

    Returns
    -------
    (H, W, n) uint8
    """
    if name in LIGHT_PASSES:
        layer = np.clip(layer, 0, 1)
        layer = np.where(layer <= 0.0031308, 12.92 * layer, 1.055 * layer ** (1 / 2.4) - 0.055)
    elif name == "NORMAL":
        layer = (layer + 1) / 2
    elif name == "DEPTH":
        layer = np.where(layer > 0, (DEPTHS[1] - layer) / (DEPTHS[1] - DEPTHS[0]), 0)
    elif name == "POSITION":
        low, high = np.array(CORNERS)
        layer = (layer - low) / (high - low)
    return np.floor(255 * np.clip(layer, 0, 1) + 0.5).astype(np.uint8)
