r"""Moments of a patch: a few numbers that give a lower bound of δ.

Let :math:`b_k` be orthogonal functions on the pixels of a patch. By Bessel's
inequality, per channel,

.. math:: \sum (f - g)^2 \ge \sum_k \frac{(\langle b_k, f\rangle - \langle b_k, g\rangle)^2}
                                         {\langle b_k, b_k \rangle}

With the constant function alone this is successive elimination by patch sums (Li and
Salari 1995). Products of the orthogonal polynomials below, up to degree two, add
slope and curvature. Guides are smooth, so their sums are enough; the grain of the style needs
all six.
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray

POLYNOMIALS: dict[int, tuple[tuple[int, ...], ...]] = {
    3: ((1, 1, 1), (-1, 0, 1), (1, -2, 1)),
    5: ((1, 1, 1, 1, 1), (-2, -1, 0, 1, 2), (2, -1, -2, -1, 2)),
}
"""Discrete orthogonal polynomials of degree 0, 1, 2 on the pixels of a row."""

BOUND_SCALE = 8
"""Fixed-point factor of the bound over δ. With it, weights of moments fit 32 bits: the weights of
guides may take 32 bits, but their only moment has a norm of at least 9; the style's moments have
a norm of at least 4, and its weights take 17 bits."""

LINE_MOMENTS = 32
"""Moments, 16 bits each, in a cache line of 64 bytes."""

CONSTANT = (0, 0)
STYLE_DEGREES: tuple[tuple[tuple[int, int], ...], ...] = (
    ((0, 1), (1, 0)),
    ((0, 2), (2, 0)),
    ((1, 1),),
)
"""Vertical and horizontal degrees of a style channel's moments after the constant. Neighbours
have equal norms, so that they can share a weight."""


def moment_width(patch_width: int) -> int:
    """Width of the central block that moments are taken of.

    Differences of its moments must fit 16 bits; those of 5 x 5 pixels do.
    """
    return min(patch_width, 5)


def squared_norm(width: int, degrees: tuple[int, int]) -> int:
    """⟨b, b⟩ of the product of two polynomials."""
    vertical, horizontal = (POLYNOMIALS[width][degree] for degree in degrees)
    return sum(v * v for v in vertical) * sum(h * h for h in horizontal)


@njit
def patch_moment(
    texture: NDArray[np.uint8],
    first_y: int,
    first_x: int,
    channel: int,
    vertical: tuple[int, ...],
    horizontal: tuple[int, ...],
) -> int:
    """⟨b, f⟩ on the block whose first pixel is ``(first_y, first_x)``.

    This is the definition, pixel by pixel; :mod:`stylit_ref.passes.patch_moments` computes the same
    numbers for all patches at once.

    Parameters
    ----------
    texture : (H, W, C) uint8
    first_y, first_x, channel : int
    vertical, horizontal : tuple of int
        Two of :data:`POLYNOMIALS`; b is their product.

    Returns
    -------
    int
    """
    total = 0
    for dy in range(len(vertical)):
        for dx in range(len(horizontal)):
            total += vertical[dy] * horizontal[dx] * texture[first_y + dy, first_x + dx, channel]
    return total
