"""Where a pixel's point appears in another frame (3.2.1).

Motion belongs to the frame that a picture is shifted *to*: it is added to a pixel of that frame,
x to the right and y downwards, and leads to the same point in the frame that the picture comes
*from*. So every pixel finds one source, and none is left without or hit twice.
"""

import math

from numba import njit


@njit
def shifted(place: int, motion: float, depth: int) -> int:
    """A coordinate in the other frame: ``place + motion / 2^depth``, rounded half up.

    Parameters
    ----------
    place : int
        A row or column of the level.
    motion : float
        In pixels of the finest level, finite.
    depth : int
        How many levels are finer.
    """
    return int(math.floor(place + motion / (1 << depth) + 0.5))  # noqa: RUF046, a float on a GPU


@njit
def representative(place: int, depth: int) -> int:
    """The pixel of the finest level whose motion a pixel of a level takes.

    It is the first one past the middle of those that the pixel covers. A mean over an edge in
    depth would belong to neither side.
    """
    return (place << depth) + ((1 << depth) >> 1)
