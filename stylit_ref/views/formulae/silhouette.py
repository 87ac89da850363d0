"""Which of two neighbouring pixels lies in front of the other, and how far strokes reach.

Depth counts by its inverse: on a plane that is affine in the picture, so that a floor that recedes
is told from a step in depth.
"""

from numba import njit

STEP = 1.05
"""What lies nearer by less than a twentieth moves alike, but for a twentieth."""

REACH, REACH_SIDE = 4, 300
"""Strokes reach 4 pixels beyond a silhouette where the longer side of a picture has 300."""


def reach_of(height: int, width: int) -> int:
    """How far strokes reach beyond a silhouette, in pixels: rounded half up, at least 1."""
    return max(1, (2 * REACH * max(height, width) + REACH_SIDE) // (2 * REACH_SIDE))


@njit
def is_nearer(inverse: float, other: float) -> bool:
    """Whether a pixel lies in front of another one, by their inverse depths."""
    return inverse > STEP * other


@njit
def is_step(before: float, near: float, far: float, behind: float) -> bool:
    """Whether depth steps back between two neighbours, rather than receding on one plane.

    Parameters
    ----------
    before, near, far, behind : float
        Inverse depths of four pixels in a row; the step is between ``near`` and ``far``.
    """
    slope = min(abs(before - near), abs(far - behind))
    return is_nearer(near, far) and near - far > 2 * slope
