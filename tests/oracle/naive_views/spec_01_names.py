"""1. Names, and rounding."""

from fractions import Fraction
from math import floor, isfinite
from typing import NamedTuple

import numpy as np

ONE = 256
NOWHERE = (-1, -1)


class Motion(NamedTuple):
    """Vectors (x, y) of floats, and where they hold."""

    field: np.ndarray
    visible: np.ndarray


def pixels(size):
    """List all pixels in rows."""
    return np.ndindex(*size)


def in_units(weight):
    """Give lambda in units of 1/256."""
    return floor(float(weight) * 256 + 0.5)


def half_up(place, component, depth):
    """Round a coordinate of the other frame half up."""
    return floor(place + Fraction(float(component)) / 2**depth + Fraction(1, 2))


def place_of(motion, pixel, depth=0):
    """Find the place of a pixel of a level; the motion is that of the finest."""
    height, width = motion.visible.shape
    y, x = pixel
    step, half = 2**depth, 2**depth // 2
    from_pixel = y * step + half, x * step + half
    dx, dy = motion.field[from_pixel]
    if not (motion.visible[from_pixel] and isfinite(dx) and isfinite(dy)):
        return NOWHERE
    row, column = half_up(y, dy, depth), half_up(x, dx, depth)
    inside = 0 <= row < height // step and 0 <= column < width // step
    return (row, column) if inside else NOWHERE


def places_of(motion, depth=0):
    """Find the places of all pixels of a level."""
    size = [side // 2**depth for side in motion.visible.shape]
    places = np.empty((*size, 2), np.int64)
    for pixel in pixels(size):
        places[pixel] = place_of(motion, pixel, depth)
    return places


def told(motion):
    """Give motion as cases have it: a vector that leads nowhere is (0, 0) and not visible."""
    visible = places_of(motion)[:, :, 0] >= 0
    return {"field": np.where(visible[:, :, None], motion.field, 0), "visible": visible}
