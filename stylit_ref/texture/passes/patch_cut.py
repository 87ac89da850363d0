"""The cut of one patch: its tables, and the best closed path through them (section 4)."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import subroutine
from stylit_ref.texture.formulae.polar import BLOCKED, MARGIN, Polar, halvings
from stylit_ref.texture.passes.context import Context
from stylit_ref.texture.passes.cut import accumulate, closed_path
from stylit_ref.texture.passes.cut_costs import cut_costs, end_rays, existing_seams
from stylit_ref.texture.passes.layout import Settings, Sources, Texture, Workspace
from stylit_ref.texture.passes.lock import (
    free_locked_edges,
    hidden_beside_locked,
    hidden_by_guide,
    magnitude,
)
from stylit_ref.texture.passes.new_seams import new_seams


@subroutine
def cut_tables(
    texture: Texture,
    sources: Sources,
    polar: Polar,
    settings: Settings,
    work: Workspace,
    thread: int,
    context: Context,
    source: int,
    y: int,
    x: int,
    halved: int,
) -> int:
    """Fill ``crossing`` and ``steps`` of the workspace for the patch around the address ``source``.

    Where no pixel is locked and there is no guide, what a patch hides does not depend on it:
    ``saved`` must be filled then, with costs halved ``halved`` times.

    Returns
    -------
    int
        How often costs are halved.
    """
    new_x, new_y = work.new_seams[thread, 0], work.new_seams[thread, 1]
    saved, crossing, steps = work.saved[thread], work.crossing[thread], work.steps[thread]
    hidden, colours, half_width = work.costs[thread, 0], sources.colours, polar.half_width
    stride, jump = settings.stride, settings.max_jump
    if settings.has_lock or settings.guide_weight:
        if settings.has_lock:
            hidden_beside_locked(
                texture, colours, settings, source, y, x, half_width, context, hidden
            )
        else:
            hidden[:] = context.seams
        if settings.guide_weight:
            hidden_by_guide(
                texture, sources.guide_colours, settings, source, y, x, half_width, context, hidden
            )
        halved = halvings(magnitude(hidden), settings.hidden_limit)
        existing_seams(hidden, polar, halved, settings.existing_limit, saved)
    new_seams(
        colours, stride, source, half_width, context, settings.eta, settings.exponent, halved,
        settings.new_limit, new_x, new_y,
    )  # fmt: skip
    if settings.has_lock:
        free_locked_edges(half_width, context, new_x, new_y)
    cut_costs(new_x, new_y, saved, polar, jump, work.row[thread, 2:], crossing, steps)
    if sources.clearance[source] <= settings.radius + MARGIN:
        end_rays(sources.clearance, stride, source, polar, jump, crossing)
    return halved


@subroutine
def find_cut(
    settings: Settings,
    crossing: NDArray[np.int32],
    steps: NDArray[np.int32],
    totals: NDArray[np.int32],
    row: NDArray[np.int32],
    path: NDArray[np.int32],
    ends: NDArray[np.int32],
) -> int:
    """The cut of section 4, and with the second pass a better one; returns what it costs.

    The paper lets a cut begin in every column for nothing, so that a cut that begins cheaply keeps
    others from the columns where they end. The second pass goes around once more: it begins in
    every column with what the first one paid to arrive there. After many turns these differences
    would no longer change, and the best closed path would be the optimum; a single one nearly
    always finds it. Should it find none that is not blocked, there is still the smallest cut,
    around the centre alone.
    """
    rows, padded = crossing.shape
    jump, blocked = settings.max_jump, np.int32(BLOCKED)
    less, more, arrivals = row[0, :padded], row[1, :padded], row[2, :padded]
    arrivals[:] = 0
    accumulate(crossing, steps, jump, arrivals, totals, less, more)
    if settings.second_pass:
        end = totals[rows]
        least = end.min()
        for x in range(padded):
            more_than_least = np.int32(end[x] - least)
            arrivals[x] = more_than_least if more_than_least < blocked else blocked
        accumulate(crossing, steps, jump, arrivals, totals, less, more)
    cost = closed_path(totals, steps, jump, arrivals, path, ends[0], ends[1])
    if settings.second_pass:
        smallest = np.int64(0)
        for y in range(rows):
            smallest += crossing[y, jump]
        if smallest < cost:
            cost = np.int32(smallest)
            path[:] = 0
    return cost
