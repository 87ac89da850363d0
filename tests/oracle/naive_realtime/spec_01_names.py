"""1. Names."""


def clamped(image, y, x):
    """Read a pixel, or the nearest one of the image."""
    return image[min(max(y, 0), image.shape[0] - 1), min(max(x, 0), image.shape[1] - 1)]


def centre_range(side, width):
    """Give the first and the last centre along a side."""
    radius = width // 2
    return min(radius, (side - 1) // 2), max(side - 1 - radius, (side - 1) // 2)


def ranges(size, width):
    """Give the first and last centre along both sides of the source."""
    return [centre_range(side, width) for side in size]


def into_range(centre, bounds):
    """Clamp (y, x) to the centres."""
    pairs = zip(centre, bounds, strict=True)
    return tuple(min(max(place, first), last) for place, (first, last) in pairs)


def grid_of(size, spacing):
    """Give rows and columns of entries."""
    return tuple((side + spacing - 1) // spacing for side in size)
