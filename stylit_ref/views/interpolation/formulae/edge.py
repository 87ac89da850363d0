"""Where the edges of polygons cross the rows of a picture, and where they meet the near plane."""

from numba import njit


@njit
def crossing(x: float, y: float, other_x: float, other_y: float, row: float) -> float:
    """Where an edge crosses a row: two polygons that share the edge find the very same place.

    Parameters
    ----------
    x, y, other_x, other_y : float
        The ends, of different y.
    row : float
        Between them.
    """
    if other_y < y:
        x, y, other_x, other_y = other_x, other_y, x, y
    return x + (row - y) * ((other_x - x) / (other_y - y))


@njit
def cut(value: float, other: float, depth: float, other_depth: float, near: float) -> float:
    """A coordinate of the point where an edge meets the near plane.

    Parameters
    ----------
    value, depth : float
        The coordinate, and the depth, of the end in front of the plane.
    other, other_depth : float
        Of the end behind it.
    near : float
        The plane's depth.
    """
    return value + (near - depth) / (other_depth - depth) * (other - value)
