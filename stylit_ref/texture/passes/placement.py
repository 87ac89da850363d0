"""One iteration: a patch for every cell of a grid, the cells side by side (sections 3 and 6)."""

import numpy as np
from numba import get_thread_id, prange
from numpy.typing import NDArray

from stylit_ref.machine.inlined import subroutine
from stylit_ref.machine.kernel import kernel
from stylit_ref.randomness.philox import FourWords
from stylit_ref.texture.formulae.polar import BLOCKED, MARGIN, Polar, halvings
from stylit_ref.texture.passes.acceptance import costs_of_change, inner_cost, write_patch
from stylit_ref.texture.passes.alignment import alignment_costs
from stylit_ref.texture.passes.candidates import exemplar_in_need, find_candidate
from stylit_ref.texture.passes.context import Context, read_context
from stylit_ref.texture.passes.cut import accumulate, closed_path
from stylit_ref.texture.passes.cut_costs import cut_costs, end_rays, existing_seams
from stylit_ref.texture.passes.deformation import rasterize
from stylit_ref.texture.passes.deformed_patch import TOO_DEAR, deformed_change
from stylit_ref.texture.passes.layout import Settings, Sources, Texture, Workspace
from stylit_ref.texture.passes.lock import (
    free_locked_edges,
    hidden_beside_locked,
    hidden_by_guide,
    magnitude,
)
from stylit_ref.texture.passes.new_seams import new_seams

PREDICATES = "none", "before", "after", "exact"
"""Whether a patch is rejected (section 6), in the order of their numbers."""

_BEFORE, _AFTER, _EXACT = 1, 2, 3

UNTRIED, REJECTED, ACCEPTED, DEFORMED = 0, 1, 2, 3
"""What became of a cell; DEFORMED is accepted, too."""


@subroutine
def find_cut(
    polar: Polar,
    settings: Settings,
    crossing: NDArray[np.int32],
    steps: NDArray[np.int32],
    totals: NDArray[np.int32],
    less: NDArray[np.int32],
    more: NDArray[np.int32],
    path: NDArray[np.int32],
    ends: NDArray[np.int32],
    columns_now: NDArray[np.int32],
) -> int:
    """The cut of section 4, and with the second pass a better one; returns what it costs.

    The second pass begins half a turn on, in the column of the cut found there, and so must end
    there. The cut found is one of those that it chooses from: it is never worse. The smallest cut,
    around the centre alone, competes too: no path from elsewhere need lead to it.
    """
    rows = path.size
    jump = settings.max_jump
    accumulate(crossing, steps, jump, 0, -1, totals, less, more)
    cost = closed_path(totals, steps, jump, 0, -1, path, ends, columns_now)
    if settings.second_pass and cost < BLOCKED // 2:
        half = rows // 2
        start = path[half]
        accumulate(crossing, steps, jump, half, start, totals, less, more)
        cost = closed_path(totals, steps, jump, half, start, path, ends, columns_now)
        smallest = np.int64(0)
        for y in range(rows):
            smallest += crossing[y, jump]
        if smallest < cost:
            cost = np.int32(smallest)
            path[:] = 0
    return cost


@subroutine
def fit_patch(
    texture: Texture,
    sources: Sources,
    polar: Polar,
    powers: NDArray[np.int32],
    settings: Settings,
    work: Workspace,
    thread: int,
    stream: FourWords,
    cell: int,
    y: int,
    x: int,
    patch: NDArray[np.int32],
) -> tuple[int, int]:
    """Choose, cut, align and judge the patch of one cell.

    Returns
    -------
    outcome, change : int
        UNTRIED, REJECTED, ACCEPTED or DEFORMED, and by how much the patch changes the cost of S.
        Where it is accepted, ``patch`` holds what is to be written.
    """
    windows, costs = work.context[thread], work.costs[thread]
    context = Context(windows[0], windows[1], windows[2], windows[3], work.locked[thread])
    new_x, new_y = work.new_seams[thread, 0], work.new_seams[thread, 1]
    hidden, other_patch = costs[0], costs[1]
    saved, crossing, steps = work.saved[thread], work.crossing[thread], work.steps[thread]
    totals, row, paths = work.totals[thread], work.row[thread], work.paths[thread]
    padded = crossing.shape[1]
    less, more = row[0, :padded], row[1, :padded]
    ends, columns_now = work.ends[thread, 0], work.ends[thread, 1]
    path, other_path, shifts = paths[0], paths[1], paths[2]
    colours, half_width = sources.colours, polar.half_width
    stride, existing_limit = settings.stride, settings.existing_limit
    eta, exponent, jump = settings.eta, settings.exponent, settings.max_jump
    depends_on_patch = settings.has_lock or settings.guide_weight

    exemplar = np.int64(-1)
    if settings.has_labels:
        exemplar = exemplar_in_need(texture, sources, settings, stream, cell, y, x)
    total, free = read_context(texture, colours, stride, y, x, half_width, exemplar, context)
    nothing_to_gain = total == 0 and not settings.guide_weight and settings.predicate
    bounds = sources.centre_bounds
    has_source = exemplar < 0 or bounds[exemplar] < bounds[exemplar + 1]
    if free == 0 or nothing_to_gain or not has_source:
        return UNTRIED, np.int64(0)
    halved = halvings(total, settings.hidden_limit)
    if not depends_on_patch:
        existing_seams(context.seams, polar, halved, existing_limit, saved)

    source, cost, best_halved = np.int64(-1), np.int64(0), halved
    hides, steps_cost = np.int64(0), np.int64(0)
    for attempt in range(settings.tries):
        candidate = find_candidate(
            texture,
            sources,
            settings,
            context,
            stream,
            cell,
            attempt * settings.prescreened,
            exemplar,
            y,
            x,
        )
        if depends_on_patch:
            if settings.has_lock:
                hidden_beside_locked(
                    texture, colours, settings, candidate, y, x, half_width, context, hidden
                )
            else:
                hidden[:] = context.seams
            if settings.guide_weight:
                hidden_by_guide(
                    texture, sources.guide_colours, settings, candidate, y, x, half_width, context,
                    hidden,
                )  # fmt: skip
            halved = halvings(magnitude(hidden), settings.hidden_limit)
            existing_seams(hidden, polar, halved, existing_limit, saved)
        new_seams(
            colours,
            stride,
            candidate,
            half_width,
            context,
            eta,
            exponent,
            halved,
            settings.new_limit,
            new_x,
            new_y,
        )
        if settings.has_lock:
            free_locked_edges(half_width, context, new_x, new_y)
        cut_costs(new_x, new_y, saved, polar, jump, row[2:], crossing, steps)
        if sources.clearance[candidate] <= settings.radius + MARGIN:
            end_rays(sources.clearance, stride, candidate, polar, jump, crossing)
        found = np.int64(
            find_cut(
                polar, settings, crossing, steps, totals, less, more, other_path, ends, columns_now
            )
        )
        if found < BLOCKED // 2 and (source < 0 or found << halved < cost):
            source, cost, best_halved = candidate, found << halved, halved
            path, other_path = other_path, path
            hides, steps_cost = np.int64(0), np.int64(0)
            for angle in range(path.size):
                column = path[angle]
                after = path[angle + 1 if angle + 1 < path.size else 0]
                hides += saved[angle, column]
                steps_cost += abs(steps[angle, jump + after] - steps[angle, jump + column])
    if source < 0:
        return REJECTED, np.int64(0)
    if cost >= 0 and (settings.predicate == _BEFORE or settings.predicate == _EXACT):
        return REJECTED, np.int64(0)
    # ℰ(C[D]): colours slide along the cut; what its steps along rays cost stays (section 5).
    aligned = np.int64(0)
    if settings.max_shift:
        shift_costs, shift_steps = work.shift_costs[thread], work.shift_steps[thread]
        alignment_costs(
            colours, settings, source, polar, path, context, best_halved, work.line[thread],
            shift_costs, shift_steps,
        )  # fmt: skip
        padded = shift_costs.shape[1]
        less, more = row[0, :padded], row[1, :padded]
        shift_totals = work.shift_totals[thread]
        accumulate(shift_costs, shift_steps, 1, 0, -1, shift_totals, less, more)
        aligned = steps_cost + closed_path(
            shift_totals, shift_steps, 1, 0, -1, shifts, ends, columns_now
        )
        for angle in range(shifts.size):
            shifts[angle] -= settings.max_shift
    if settings.predicate == _AFTER and cost >= 0 and aligned >= hides:
        return REJECTED, np.int64(0)  # whatever the deformation costs inside

    whole = rasterize(
        source, settings, polar, path, shifts, powers, False, sources.clearance, context, patch
    )
    before, after = costs_of_change(texture, sources, settings, y, x, half_width, patch)
    change, outcome = after - before, ACCEPTED
    if settings.max_shift:
        most = after if whole else np.int64(TOO_DEAR)
        deformed = deformed_change(
            texture, sources, settings, polar, y, x, source, path, shifts, powers, context, most,
            other_patch,
        )  # fmt: skip
        if deformed < change:
            change, outcome = deformed, DEFORMED
            patch[:] = other_patch
    if settings.predicate == _AFTER:
        if outcome == DEFORMED:
            improves = (
                aligned + (inner_cost(patch, half_width, colours, settings) >> best_halved) - hides
                < 0
            )
        else:
            improves = cost < 0
        if not improves:
            return REJECTED, np.int64(0)
    if settings.predicate == _EXACT and change >= 0:
        return REJECTED, np.int64(0)
    return outcome, change


@kernel()
def _iterate(
    texture, sources, polar, powers, settings, work, stream, cells, patches, outcomes, changes
):
    # First all cells are read, then all are written: a window reaches into the next cells.
    for cell in prange(cells.shape[0]):
        outcomes[cell], changes[cell] = fit_patch(
            texture, sources, polar, powers, settings, work, get_thread_id(), stream, cell,
            cells[cell, 0], cells[cell, 1], patches[cell],
        )  # fmt: skip
    for cell in prange(cells.shape[0]):
        if outcomes[cell] >= 2:
            write_patch(
                texture, sources, settings, cells[cell, 0], cells[cell, 1], polar.half_width,
                patches[cell],
            )  # fmt: skip


def iterate(
    texture: Texture,
    sources: Sources,
    polar: Polar,
    powers: NDArray[np.int32],
    settings: Settings,
    work: Workspace,
    stream: FourWords,
    cells: NDArray[np.int64],
    patches: NDArray[np.int32],
    outcomes: NDArray[np.int64],
    changes: NDArray[np.int64],
) -> None:
    """Offer a patch to every cell, and write those that are accepted.

    Parameters
    ----------
    texture : Texture
        Changed in place.
    sources : Sources
    polar : Polar
        For ``settings.radius``.
    powers : (4097,) int32
        From :func:`stylit_ref.texture.formulae.deformation.power_table`.
    settings : Settings
    work : Workspace
    stream : tuple of 4 uint32
        Random numbers of this iteration.
    cells : (n, 2) int64
        Centres (y, x) of the cells, at least 2R apart on the torus in y or in x.
    patches : (n, places) int32
        Receives what each cell writes.
    outcomes, changes : (n,) int64
        Receive what became of each cell, and by how much it changed the cost of S.
    """
    _iterate(
        texture, sources, polar, powers, settings, work, stream, cells, patches, outcomes, changes
    )
