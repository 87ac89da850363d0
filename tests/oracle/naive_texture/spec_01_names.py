"""1. Names."""

import math

BLOCKED = 2**30 - 1


def r10(value):
    """Round a value in units of 2**-10."""
    return (value + 512) >> 10


def half_width(radius, v):
    """Give how far the disc reaches in a row."""
    return math.isqrt(max((2 * radius + 3) ** 2 - 4 * v**2, 0)) // 2


def in_disc(radius, dy, dx):
    """Tell whether a place is in the disc."""
    return abs(dy) <= radius + 1 and abs(dx) <= half_width(radius, dy)


def reach(radius):
    """List (dy, dx) of all places that a patch reads."""
    places = []
    for _, dy, dx in window(radius):
        widest = max(half_width(radius, v) for v in (dy, max(dy - 1, -radius - 2)))
        if abs(dx) <= min(widest + 1, radius + 2):
            places.append((dy, dx))
    return places


def window(radius):
    """List (place, dy, dx) of a patch's window, row by row."""
    span = range(-radius - 2, radius + 3)
    pairs = [(dy, dx) for dy in span for dx in span]
    return [(place, dy, dx) for place, (dy, dx) in enumerate(pairs)]


def offset_of(place, radius):
    """Give (dy, dx) of a place."""
    dy, dx = divmod(place, 2 * radius + 5)
    return dy - radius - 2, dx - radius - 2
