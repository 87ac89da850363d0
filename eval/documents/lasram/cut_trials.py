"""Cut patches as the synthesizer does, and from every column: the least of these is the optimum."""

from dataclasses import dataclass

import numba
import numpy as np
from numba import get_thread_id, prange

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.texture.formulae.polar import BLOCKED, MARGIN, halvings
from stylit_ref.texture.formulae.seam_cost import ONE
from stylit_ref.texture.passes.context import Context, read_context
from stylit_ref.texture.passes.cut import accumulate
from stylit_ref.texture.passes.cut_costs import cut_costs, end_rays, existing_seams
from stylit_ref.texture.passes.layout import make_workspace
from stylit_ref.texture.passes.new_seams import new_seams
from stylit_ref.texture.passes.patch_cut import find_cut


@dataclass(frozen=True)
class CutTrials:
    """What the cuts of some patches cost, less the seams that they hide, in units of M.

    Attributes
    ----------
    first, second : (n,) float64
        The cut of one pass, and what a second one makes of it.
    every : (n, W) float64
        The best closed cut through each column of the first row; infinite where it is blocked.
    """

    first: np.ndarray
    second: np.ndarray
    every: np.ndarray

    @property
    def optimum(self):
        """(n,) the best closed cut: it passes the first row somewhere."""
        return self.every.min(axis=1)

    def rank(self, cut):
        """(n,) 1 and how many columns have a better cut than ``cut``."""
        return 1 + (self.every < cut[:, None]).sum(axis=1)


@inlined
def _cost(units, halved):
    """What a cut costs in units of M; infinite if it is blocked."""
    return np.inf if units >= BLOCKED // 2 else float(np.int64(units) << halved) / ONE


@kernel()
def _try_cuts(
    texture, sources, polar, once, twice, hides, work, places, centres, first, second, every
):
    columns = polar.inside.shape[1]
    settings, jump = once, once.max_jump
    for trial in prange(places.shape[0]):
        thread = get_thread_id()
        windows = work.context[thread]
        context = Context(windows[0], windows[1], windows[2], windows[3], work.locked[thread])
        new_x, new_y = work.new_seams[thread, 0], work.new_seams[thread, 1]
        saved, crossing, steps = work.saved[thread], work.crossing[thread], work.steps[thread]
        totals, row, path = work.totals[thread], work.row[thread], work.paths[thread, 0]
        padded = crossing.shape[1]
        less, more, arrivals = row[0, :padded], row[1, :padded], row[2, :padded]
        ends = work.ends[thread]
        source = np.int64(centres[trial])
        total, _ = read_context(
            texture, sources.colours, settings.stride, places[trial, 0], places[trial, 1],
            polar.half_width, -1, context,
        )  # fmt: skip
        halved = np.int64(0)
        if hides:
            halved = np.int64(halvings(total, settings.hidden_limit))
            existing_seams(context.seams, polar, halved, settings.existing_limit, saved)
        else:
            saved[:] = 0
        new_seams(
            sources.colours, settings.stride, source, polar.half_width, context, settings.eta,
            settings.exponent, halved, settings.new_limit, new_x, new_y,
        )  # fmt: skip
        cut_costs(new_x, new_y, saved, polar, jump, row[2:], crossing, steps)
        if sources.clearance[source] <= settings.radius + MARGIN:
            end_rays(sources.clearance, settings.stride, source, polar, jump, crossing)
        first[trial] = _cost(find_cut(once, crossing, steps, totals, row, path, ends), halved)
        second[trial] = _cost(find_cut(twice, crossing, steps, totals, row, path, ends), halved)
        for start in range(columns):
            arrivals[:] = BLOCKED
            arrivals[jump + start] = 0
            accumulate(crossing, steps, jump, arrivals, totals, less, more)
            every[trial, start] = _cost(totals[path.size, jump + start], halved)


def try_cuts(session, places, centres, *, hides):
    """Cut patches by one pass, by two, and through every column.

    Parameters
    ----------
    session : TextureSession
        What the patches are laid over. R, J_max and the weighting are those of its parameters.
    places : (n, 2) int64
        Their centres (y, x) in the texture.
    centres : (n,) int32
        Their centres in the exemplars, as addresses.
    hides : bool
        Whether a cut gains what the seams it hides cost (ℰ), or they count nothing.

    Returns
    -------
    CutTrials
    """
    polar, sources, settings = session.fitted(session.params.radius)
    columns = polar.inside.shape[1]
    work = make_workspace(polar, settings.max_jump, 0, numba.get_num_threads())
    first, second = np.empty((2, len(places)))
    every = np.empty((len(places), columns))
    _try_cuts(
        session.texture, sources, polar, settings._replace(second_pass=0),
        settings._replace(second_pass=1), hides, work, places, centres, first, second, every,
    )  # fmt: skip
    return CutTrials(first, second, every)
