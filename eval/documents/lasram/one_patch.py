"""One patch, pass by pass: what figures of a patch show."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from stylit_ref.texture.formulae.deformation import power_table
from stylit_ref.texture.formulae.polar import BLOCKED
from stylit_ref.texture.passes.acceptance import cost_change
from stylit_ref.texture.passes.alignment import alignment_costs
from stylit_ref.texture.passes.context import Context, read_context
from stylit_ref.texture.passes.cut import accumulate, closed_path
from stylit_ref.texture.passes.cut_costs import cut_costs, end_rays, existing_seams
from stylit_ref.texture.passes.deformation import rasterize
from stylit_ref.texture.passes.layout import make_workspace
from stylit_ref.texture.passes.new_seams import new_seams
from stylit_ref.texture.session import TextureSession


@dataclass
class OnePatch:
    """A patch at a place of a texture.

    Its stages are methods. They are to be called in their order; each may be called again.

    Attributes
    ----------
    session : TextureSession
        Its parameters shape the patch; its texture stays as it is.
    place : tuple of int
        The patch's centre (y, x) in the texture.
    source : int
        Its centre in the exemplars, as an address.
    """

    session: TextureSession
    place: tuple[int, int]
    source: int

    def __post_init__(self):
        self.polar, self.sources, self.settings = self.session.fitted(self.session.params.radius)
        jump, shift = self.settings.max_jump, self.settings.max_shift
        self.work = make_workspace(self.polar, jump, shift, 1)
        windows = self.work.context[0]
        self.context = Context(*windows, self.work.locked[0])
        self.path, self.shifts = self.work.paths[0, 0], self.work.paths[0, 2]
        self.patch = np.empty(self.polar.radius_at.size, np.int32)
        self.deformed = self.patch.copy()
        self.cost = self.aligned = 0

    def read(self):
        """Read what lies under the patch."""
        read_context(
            self.session.texture, self.sources.colours, self.settings.stride, *self.place,
            self.polar.half_width, -1, self.context,
        )  # fmt: skip

    def begin_cut(self):
        """M of section 4, and H, V and ℰ."""
        settings, polar, work = self.settings, self.polar, self.work
        new_x, new_y = work.new_seams[0]
        existing_seams(self.context.seams, polar, 0, settings.existing_limit, work.saved[0])
        new_seams(
            self.sources.colours, settings.stride, self.source, polar.half_width, self.context,
            settings.eta, settings.exponent, 0, settings.new_limit, new_x, new_y,
        )  # fmt: skip
        cut_costs(
            new_x, new_y, work.saved[0], polar, settings.max_jump, work.row[0, 2:],
            work.crossing[0], work.steps[0],
        )  # fmt: skip
        end_rays(
            self.sources.clearance, settings.stride, self.source, polar, settings.max_jump,
            work.crossing[0],
        )  # fmt: skip

    def cut(self):
        """C, by one pass."""
        self.cost = self._solve(
            self.work.crossing[0], self.work.steps[0], self.work.totals[0], self.settings.max_jump,
            self.path,
        )  # fmt: skip

    def begin_alignment(self):
        """M_D of section 5."""
        alignment_costs(
            self.sources.colours, self.settings, self.source, self.polar, self.path, self.context,
            0, self.work.line[0], self.work.shift_costs[0], self.work.shift_steps[0],
        )  # fmt: skip

    def align(self, start=-1):
        """D: the shift in each row; ``start`` fixes that in the first row, from 0 for -D_max."""
        self.aligned = self._solve(
            self.work.shift_costs[0], self.work.shift_steps[0], self.work.shift_totals[0], 1,
            self.shifts, start,
        )  # fmt: skip
        self.shifts -= self.settings.max_shift

    def write(self):
        """The addresses of the patch, without deformation and with it, and what they change."""
        for patch, is_deformed in ((self.patch, False), (self.deformed, True)):
            rasterize(
                self.source, self.settings, self.polar, self.path, self.shifts, self._powers,
                is_deformed, self.sources.clearance, self.context, patch,
            )  # fmt: skip
            cost_change(
                self.session.texture, self.sources, self.settings, *self.place,
                self.polar.half_width, patch,
            )  # fmt: skip

    @cached_property
    def _powers(self):
        return power_table(self.session.params.gamma)

    def _solve(self, costs, steps, totals, jump, path, start=-1):
        row, ends = self.work.row[0], self.work.ends[0]
        less, more, arrivals = row[:3, : costs.shape[1]]
        arrivals[:] = 0 if start < 0 else BLOCKED
        arrivals[jump + max(start, 0)] = 0
        accumulate(costs, steps, jump, arrivals, totals, less, more)
        return int(closed_path(totals, steps, jump, arrivals, path, *ends))
