"""A patch that a person drags over S, and drops (section 8, "Patch drag-and-drop")."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.texture.formulae.polar import BLOCKED, Polar, halvings
from stylit_ref.texture.passes.acceptance import cost_change, write_patch
from stylit_ref.texture.passes.context import Context, read_context
from stylit_ref.texture.passes.cut_costs import existing_seams
from stylit_ref.texture.passes.deformation import OUTSIDE, rasterize
from stylit_ref.texture.passes.layout import Settings, Sources, Texture, Workspace
from stylit_ref.texture.passes.patch_cut import cut_tables, find_cut


@kernel(parallel=False)
def _fit_dragged(
    texture, sources, polar, settings, work, source, y, x, least_radius, powers, patch, change
):
    windows = work.context[0]
    context = Context(windows[0], windows[1], windows[2], windows[3], work.locked[0])
    crossing, path, shifts = work.crossing[0], work.paths[0, 0], work.paths[0, 1]
    half_width = polar.half_width
    total, _ = read_context(
        texture, sources.colours, settings.stride, y, x, half_width, np.int64(-1), context
    )
    halved = halvings(total, settings.hidden_limit)
    existing_seams(context.seams, polar, halved, settings.existing_limit, work.saved[0])
    cut_tables(texture, sources, polar, settings, work, 0, context, source, y, x, halved)
    # All cuts hide what is nearer, so it counts for none of them.
    for column in range(polar.border.size - 1):
        if polar.border[column + 1] < least_radius << 8:
            crossing[:, settings.max_jump + column] = BLOCKED
    cost = find_cut(
        settings, crossing, work.steps[0], work.totals[0], work.row[0], path, work.ends[0]
    )
    patch[:] = OUTSIDE
    change[0] = 0
    if cost < BLOCKED // 2:
        rasterize(
            source, settings, polar, path, shifts, powers, False, sources.clearance, context, patch
        )
        change[0] = cost_change(texture, sources, settings, y, x, half_width, patch)


@kernel(parallel=False)
def _write_dragged(texture, sources, settings, y, x, half_width, patch, change):
    change[0] = cost_change(texture, sources, settings, y, x, half_width, patch)
    write_patch(texture, sources, settings, y, x, half_width, patch)


def fit_dragged(
    texture: Texture,
    sources: Sources,
    polar: Polar,
    settings: Settings,
    work: Workspace,
    source: int,
    y: int,
    x: int,
    least_radius: int,
    powers: NDArray[np.int32],
    patch: NDArray[np.int32],
    change: NDArray[np.int64],
) -> None:
    """Cut the patch around the address ``source`` for the pixel (y, x) of S, which stays as it is.

    Parameters
    ----------
    texture, sources, polar, settings, work
        As of :func:`stylit_ref.texture.passes.placement.iterate`.
    source, y, x : int
    least_radius : int
        The cut lies nowhere nearer to the centre, in pixels.
    powers : (4097,) int32
    patch : (n * n,) int32
        Receives addresses, :data:`stylit_ref.texture.passes.deformation.OUTSIDE` outside the cut.
    change : (1,) int64
        Receives what S costs with the patch, less what it costs now.
    """
    _fit_dragged(
        texture, sources, polar, settings, work, source, y, x, least_radius, powers, patch, change
    )


def write_dragged(
    texture: Texture,
    sources: Sources,
    settings: Settings,
    y: int,
    x: int,
    half_width: NDArray[np.int32],
    patch: NDArray[np.int32],
    change: NDArray[np.int64],
) -> None:
    """Write such a patch into S; ``change`` receives by how much its cost changes."""
    _write_dragged(texture, sources, settings, y, x, half_width, patch, change)
