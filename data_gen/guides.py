"""8-bit guides from the layers of a view.

====================  ====================================================
light passes          scene-linear, sRGB curve, clipped at 1
masks, FRESNEL,       values in [0, 1] as they are
WIREFRAME
NORMAL                (n + 1) / 2
DEPTH                 1 at the near limit of the scene, 0 at the far one
POSITION              each axis between the limits of the scene
====================  ====================================================

All round half up. ``stylit-ref`` applies the sRGB curve to every layer of an EXR that it is
given, so it sees the same values for the light passes only.
"""

from typing import NamedTuple

import numpy as np

LIGHT_PASSES = ("FULL", "LDE", "LSE", "LDDE", "LD12E")


class Limits(NamedTuple):
    """Between what DEPTH and POSITION are spread over 8 bits, in the units of the stage."""

    near: float
    far: float
    low: tuple
    high: tuple


STAGE_LIMITS = Limits(6.0, 13.5, (-4.0, 0.0, -4.0), (4.0, 5.0, 4.0))
HOUSE_LIMITS = Limits(11.0, 36.0, (-9.0, 0.0, -9.0), (9.0, 7.0, 9.0))
CHAPEL_LIMITS = Limits(12.0, 38.0, (-9.0, 0.0, -9.0), (9.0, 8.0, 9.0))


def guide(name, layer, limits=STAGE_LIMITS):
    """A layer as an 8-bit image.

    Parameters
    ----------
    name : str
    layer : (H, W, n) float
    limits : Limits

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
        layer = np.where(layer > 0, (limits.far - layer) / (limits.far - limits.near), 0)
    elif name == "POSITION":
        low, high = np.array(limits.low), np.array(limits.high)
        layer = (layer - low) / (high - low)
    return to_uint8(layer)


def to_uint8(image):
    """Values in [0, 1] on 8 bits, rounded half up."""
    return np.floor(255 * np.clip(image, 0, 1) + 0.5).astype(np.uint8)
