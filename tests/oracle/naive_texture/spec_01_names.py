"""1. Names."""

BLOCKED = 2**30 - 1


def r14(value):
    """Round a value in units of 2**-14."""
    return (value + 8192) >> 14


def window(radius):
    """List (place, dy, dx) of a patch's window, row by row."""
    span = range(-radius - 2, radius + 3)
    pairs = [(dy, dx) for dy in span for dx in span]
    return [(place, dy, dx) for place, (dy, dx) in enumerate(pairs)]


def offset_of(place, radius):
    """Give (dy, dx) of a place."""
    dy, dx = divmod(place, 2 * radius + 5)
    return dy - radius - 2, dx - radius - 2
