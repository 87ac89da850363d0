"""How much the views around a place count: in whole numbers, so that a shader agrees.

Along an axis of the grid a place lies between two views. The weight of the second is held in units
of 1/256, and the first one has the rest. A view has the product of its weights along both axes, in
units of 1/65536; those of the four views around a place sum up to 65536.
"""

import math

from numba import njit

ONE = 256
"""The weight of a view that counts alone along an axis."""

WHOLE = ONE * ONE
"""The weight of a view that counts alone."""


def linear_weight(at: float, low: float, high: float) -> int:
    """The second view's weight, in proportion: ``256 (at - low) / (high - low)``, rounded half up.

    Parameters
    ----------
    at : float
        The place, between the two.
    low, high : float
        Where the two views are; equal if they are one, whose weight is 0.
    """
    if high == low:
        return 0
    return math.floor((at - low) / (high - low) * ONE + 0.5)


def fading_weight(at: float, low: float, high: float, band: float) -> int:
    """The second view's weight if views fade into each other around the middle between them.

    256 (1/2 + (at - middle) / (band (high - low))), rounded half up, from 0 to 256.

    Parameters
    ----------
    at, low, high
        As of :func:`linear_weight`.
    band : float
        How wide the fade is, as a part of the way from view to view; 0 switches in the middle,
        where the first view counts.
    """
    middle = (low + high) / 2
    width = band * (high - low)
    if width == 0:
        return ONE if at > middle else 0
    weight = math.floor((0.5 + (at - middle) / width) * ONE + 0.5)
    return min(max(weight, 0), ONE)


@njit
def weighted_mean(total: int, weights: int) -> int:
    """Σ w v / Σ w, rounded half up.

    Parameters
    ----------
    total : int
        Σ w v of bytes; below 2^24 if the weights sum up to 65536, so that 32 bits hold twice as
        much.
    weights : int
        Σ w, more than 0.
    """
    return (2 * total + weights) // (2 * weights)
