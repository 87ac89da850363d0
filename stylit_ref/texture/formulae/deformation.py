"""Where a deformed patch takes its pixels from (section 5, "Deformation propagation").

::

    y' = lerp(y, D[y], (x / C[y]) ** γ)
    x' = x C[y'] / C[y]

Radii are in pixels times 2**8, angles in rows times 2**8, positions in quarter pixels. The power is
a table over the ratio in steps of 1/4096; quotients of integers are rounded down; C at a fraction
of a row is C of the nearest one. D is held as the shift D[y] - y, which is the short way round.
"""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined
from stylit_ref.texture.formulae.polar import WEIGHT_BITS

PHASES = 4
"""Positions a pixel on either axis, when S holds fractions of a pixel."""

_RATIO_BITS = 12
_POSITION_BITS = 8 + WEIGHT_BITS - 2
"""Fractional bits of a radius times a cosine that are not those of a quarter pixel."""


@lru_cache(maxsize=4)
def power_table(gamma: float) -> NDArray[np.int32]:
    """(k / 4096) ** γ for k = 0 to 4096, times 4096, rounded half up."""
    ratios = np.arange((1 << _RATIO_BITS) + 1) / (1 << _RATIO_BITS)
    return np.floor(ratios**gamma * (1 << _RATIO_BITS) + 0.5).astype(np.int32)


@inlined
def deformed_angle(
    radius: int, angle: int, border: int, shift: int, powers: NDArray[np.int32], rows: int
) -> int:
    """Y' in 1/256 rows, for a pixel at ``radius``, ``angle`` whose row has C = ``border``."""
    ratio = min(np.int64(radius) * (1 << _RATIO_BITS) // border, 1 << _RATIO_BITS)
    moved = np.int64(angle) + ((np.int64(shift) * powers[ratio]) >> (_RATIO_BITS - 8))
    return moved % (rows * 256)


@inlined
def position(
    radius: int, angle: int, cosine: NDArray[np.int32], sine: NDArray[np.int32]
) -> tuple[int, int]:
    """T^-1 as quarter pixels (y, x) from the centre; rows' sines are interpolated."""
    row, share = angle >> 8, angle & 255
    across = cosine[row] + (((cosine[row + 1] - cosine[row]) * share) >> 8)
    along = sine[row] + (((sine[row + 1] - sine[row]) * share) >> 8)
    half = np.int64(1) << (_POSITION_BITS - 1)
    y = (np.int64(radius) * along + half) >> _POSITION_BITS
    x = (np.int64(radius) * across + half) >> _POSITION_BITS
    return y, x


@inlined
def address_at(
    source: int, quarter_y: int, quarter_x: int, stride: int, plane: int, fractions: int
) -> int:
    """The address of a position given in quarter pixels from the address ``source``.

    Exemplars hold a plane of colours for each of the 16 fractions of a pixel; without ``fractions``
    there is one plane, and positions are rounded half up to whole pixels.
    """
    if fractions:
        phase = (quarter_y & 3) * PHASES + (quarter_x & 3)
        return phase * plane + source + (quarter_y >> 2) * stride + (quarter_x >> 2)
    return source + ((quarter_y + 2) >> 2) * stride + ((quarter_x + 2) >> 2)
