"""One iteration: a patch for every cell of a grid, the cells side by side (sections 3 and 6)."""

import numpy as np
from numba import get_thread_id, prange
from numpy.typing import NDArray

from stylit_ref.machine.inlined import subroutine
from stylit_ref.machine.kernel import kernel
from stylit_ref.randomness.philox import FourWords
from stylit_ref.texture.formulae.polar import BLOCKED, Polar, halvings
from stylit_ref.texture.passes.acceptance import costs_of_change, inner_cost, write_patch
from stylit_ref.texture.passes.alignment import alignment_costs
from stylit_ref.texture.passes.candidates import exemplar_in_need, find_candidate
from stylit_ref.texture.passes.context import Context, read_context
from stylit_ref.texture.passes.cut import accumulate, closed_path
from stylit_ref.texture.passes.cut_costs import existing_seams
from stylit_ref.texture.passes.deformation import rasterize
from stylit_ref.texture.passes.deformed_patch import TOO_DEAR, deformed_change
from stylit_ref.texture.passes.layout import Settings, Sources, Texture, Workspace
from stylit_ref.texture.passes.patch_cut import cut_tables, find_cut
from stylit_ref.texture.passes.use import price_use

PREDICATES = "none", "before", "after", "exact"
"""Whether a patch is rejected (section 6), in the order of their numbers."""

_BEFORE, _AFTER, _EXACT = 1, 2, 3

UNTRIED, REJECTED, ACCEPTED, DEFORMED = 0, 1, 2, 3
"""What became of a cell; DEFORMED is accepted, too."""


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
    windows = work.context[thread]
    context = Context(windows[0], windows[1], windows[2], windows[3], work.locked[thread])
    saved, crossing, steps = work.saved[thread], work.crossing[thread], work.steps[thread]
    totals, row, paths = work.totals[thread], work.row[thread], work.paths[thread]
    ends, other_patch = work.ends[thread], work.costs[thread, 1]
    path, other_path, shifts = paths[0], paths[1], paths[2]
    colours, half_width, jump = sources.colours, polar.half_width, settings.max_jump

    exemplar = np.int64(-1)
    if settings.has_labels:
        exemplar = exemplar_in_need(texture, sources, settings, stream, cell, y, x)
    total, free = read_context(
        texture, colours, settings.stride, y, x, half_width, exemplar, context
    )
    nothing_to_gain = total == 0 and not settings.guide_weight and settings.predicate
    bounds = sources.centre_bounds
    has_source = exemplar < 0 or bounds[exemplar] < bounds[exemplar + 1]
    if free == 0 or nothing_to_gain or not has_source:
        return UNTRIED, np.int64(0)
    halved = halvings(total, settings.hidden_limit)
    if not (settings.has_lock or settings.guide_weight):
        existing_seams(context.seams, polar, halved, settings.existing_limit, saved)

    source, cost, best_halved = np.int64(-1), np.int64(0), halved
    hides, steps_cost = np.int64(0), np.int64(0)
    for attempt in range(settings.tries):
        candidate = find_candidate(
            texture, sources, settings, context, stream, cell, attempt * settings.prescreened,
            exemplar, y, x,
        )  # fmt: skip
        halved = cut_tables(
            texture, sources, polar, settings, work, thread, context, candidate, y, x, halved
        )
        found = np.int64(find_cut(settings, crossing, steps, totals, row, other_path, ends))
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
    if settings.predicate == _BEFORE and cost >= 0:
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
        less, more, arrivals = row[0, :padded], row[1, :padded], row[2, :padded]
        shift_totals = work.shift_totals[thread]
        arrivals[:] = 0
        accumulate(shift_costs, shift_steps, 1, arrivals, shift_totals, less, more)
        aligned = steps_cost + closed_path(
            shift_totals, shift_steps, 1, arrivals, shifts, ends[0], ends[1]
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
    deformed, change_deformed = False, np.int64(0)
    if settings.max_shift:
        most = after if whole else np.int64(TOO_DEAR)
        change_deformed = deformed_change(
            texture, sources, settings, polar, y, x, source, path, shifts, powers, context, most,
            other_patch,
        )  # fmt: skip
        deformed = change_deformed < change
        if deformed and settings.predicate == _AFTER:
            inner = inner_cost(other_patch, half_width, colours, settings)
            deformed = aligned + (inner >> best_halved) < hides
    if deformed:
        change, outcome = change_deformed, DEFORMED
        patch[:] = other_patch
    elif settings.predicate == _AFTER and cost >= 0:
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
        Its prices are computed anew.
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
    if settings.spread:
        price_use(texture.addresses, sources.clearance, sources.centres, settings, sources.prices)
    _iterate(
        texture, sources, polar, powers, settings, work, stream, cells, patches, outcomes, changes
    )
