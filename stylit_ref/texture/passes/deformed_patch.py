"""A deformed patch beside the plain one: it is written only if it costs S less."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import subroutine
from stylit_ref.texture.formulae.polar import Polar
from stylit_ref.texture.passes.acceptance import costs_of_row
from stylit_ref.texture.passes.context import Context
from stylit_ref.texture.passes.deformation import rasterize_row
from stylit_ref.texture.passes.layout import Settings, Sources, Texture

TOO_DEAR = (1 << 63) - 1
"""Stands for a change that is not below that of the plain patch."""


@subroutine
def deformed_change(
    texture: Texture,
    sources: Sources,
    settings: Settings,
    polar: Polar,
    y: int,
    x: int,
    source: int,
    path: NDArray[np.int32],
    shifts: NDArray[np.int32],
    powers: NDArray[np.int32],
    context: Context,
    most: int,
    patch: NDArray[np.int32],
) -> int:
    """Rasterize a deformed patch, and compute what it changes, row by row.

    The plain patch changes the same pixels, so the two hide the same costs, and what they bring
    decides. It only grows from row to row: once it reaches ``most``, the rest is left out.

    Parameters
    ----------
    most : int
        What S costs with the plain patch where that changes it; or :data:`TOO_DEAR` if the plain
        patch lacks pixels, since the deformed one may then hide more.
    patch : (n * n,) int32
        Receives the patch, unless it is too dear.

    Returns
    -------
    int
        By how much it changes the cost of S, or :data:`TOO_DEAR`.
    """
    side = polar.half_width.size
    before, after = np.int64(0), np.int64(0)
    for j in range(side):
        rasterize_row(
            source, settings, polar, path, shifts, powers, True, sources.clearance, context, patch,
            j,
        )  # fmt: skip
        if j >= 2:  # a row's edges need the next
            row_before, row_after = costs_of_row(
                texture, sources, settings, y, x, polar.half_width, patch, j - 1
            )
            before += row_before
            after += row_after
            if after >= most:
                return np.int64(TOO_DEAR)
    return after - before
