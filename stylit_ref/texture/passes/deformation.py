"""Write a patch: which address each pixel inside the cut gets (section 5)."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import subroutine
from stylit_ref.texture.formulae.deformation import address_at, deformed_angle, position
from stylit_ref.texture.formulae.polar import Polar, row_of
from stylit_ref.texture.passes.context import Context
from stylit_ref.texture.passes.layout import LOCKED, Settings

OUTSIDE = -1
"""Stands for a pixel that a patch leaves alone."""


@subroutine
def rasterize(
    source: int,
    settings: Settings,
    polar: Polar,
    path: NDArray[np.int32],
    shifts: NDArray[np.int32],
    powers: NDArray[np.int32],
    deformed: bool,
    clearance: NDArray[np.uint16],
    context: Context,
    patch: NDArray[np.int32],
) -> bool:
    """Fill (n * n,) int32 addresses, :data:`OUTSIDE` where a pixel keeps what S has.

    A pixel is inside if it is nearer to the centre than the cut in the row nearest to its angle, is
    not locked, and the exemplar has the pixel that belongs there.

    Parameters
    ----------
    path : (H,) int32
        C, columns of 0 to W - 1; the cut lies behind them.
    shifts : (H,) int32
        D[y] - y; read only if ``deformed``.

    Returns
    -------
    bool
        Whether the exemplar has all pixels that belong inside.
    """
    whole = True
    for j in range(polar.half_width.size):
        whole &= rasterize_row(
            source, settings, polar, path, shifts, powers, deformed, clearance, context, patch, j
        )
    return whole


@subroutine
def rasterize_row(
    source: int,
    settings: Settings,
    polar: Polar,
    path: NDArray[np.int32],
    shifts: NDArray[np.int32],
    powers: NDArray[np.int32],
    deformed: bool,
    clearance: NDArray[np.uint16],
    context: Context,
    patch: NDArray[np.int32],
    j: int,
) -> bool:
    """Row ``j`` of the window alone."""
    stride, plane, fractions = settings.stride, settings.plane, settings.fractions
    rows = path.size
    side = polar.half_width.size
    centre = side // 2
    first = j * side
    reach = min(polar.half_width[j], centre)
    whole = True
    for i in range(side):
        patch[first + i] = OUTSIDE
    for i in range(centre - reach, centre + reach + 1):
        place = first + i
        radius, angle = polar.radius_at[place], polar.angle_at[place]
        row = row_of(angle, rows)
        border = polar.border[path[row] + 1]
        if radius >= border or context.locked[place] & LOCKED:
            continue
        a = np.int64(source) + (j - centre) * stride + i - centre
        if deformed and shifts[row] != 0:
            turned = deformed_angle(radius, angle, border, shifts[row], powers, rows)
            stretched = np.int64(radius) * polar.border[path[row_of(turned, rows)] + 1] // border
            quarter_y, quarter_x = position(stretched, turned, polar.cosine, polar.sine)
            a = address_at(source, quarter_y, quarter_x, stride, plane, fractions)
        if clearance[a % plane if deformed else a]:
            patch[place] = a
        else:
            whole = False
    return whole
