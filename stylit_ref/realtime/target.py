"""The target as the search reads it: guides B on all levels, and B' as it grows."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.thread_count import using_threads
from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.realtime.formulae.grid import grid_size
from stylit_ref.realtime.layout import Layout
from stylit_ref.realtime.passes.image import Image, interior, make_image

_FEW_PIXELS = 16384
"""An image of fewer is made by one thread, as waking others takes longer."""


class Target:
    """B and B'.

    Parameters
    ----------
    height, width : int
    layout : Layout

    Attributes
    ----------
    size : tuple of int
    grids : list of tuple of int
        Rows and columns of entries by level.
    guides : list of Image
        B by level; four bytes at the end of every pixel are spare.
    picture : list of Image
        B' by level, with a border.
    guide_records, picture_records : list of Image
        Records of the scale space by level, one for every entry; empty without it.
    labels : list of (rows, columns) int16
        The label of every entry by level, or -1; arrays of no entries if there are none.
    """

    layout: Layout
    size: tuple[int, int]
    grids: list[tuple[int, int]]
    guides: list[Image]
    picture: list[Image]
    labels: list[NDArray[np.int16]]

    def __init__(self, height: int, width: int, layout: Layout) -> None:
        self.layout = layout
        params, lanes = layout.params, layout.lanes
        sizes = layout.sizes(height, width)
        self.size = height, width
        self.guides = [make_image(*size, layout.border, lanes) for size in sizes]
        self.picture = [make_image(*size, layout.border, STYLE_LANES) for size in sizes]
        self.grids = [
            (grid_size(h, params.step), grid_size(w, params.step))
            for h, w in sizes[: params.levels]
        ]
        self.guide_records: list[Image] = []
        self.picture_records: list[Image] = []
        if params.scale_space:
            for grid in self.grids:
                self.guide_records.append(make_image(*grid, 0, lanes * params.depth))
                self.picture_records.append(make_image(*grid, 0, STYLE_LANES * params.depth))
        self.labels = [np.zeros((0, 0), np.int16)] * params.levels

    @property
    def view(self) -> NDArray[np.uint8]:
        """Where the guides are written, (height, width, channels), strided."""
        return interior(self.guides[0], self.layout.lanes)[..., : self.layout.channels]

    def set_guides(self, guides: NDArray[np.uint8]) -> None:
        """B, (height, width, channels)."""
        layout = self.layout
        layout.passes.make_fill(layout.channels, layout.lanes)(guides.reshape(-1), self.guides[0])
        self._follow()

    def view_changed(self) -> None:
        """Tell that :attr:`view` was written to."""
        self.layout.passes.make_extend(self.layout.lanes)(self.guides[0])
        self._follow()

    def _follow(self):
        layout, lanes = self.layout, self.layout.lanes
        params, passes = layout.params, layout.passes
        needed = [level for level in range(params.levels) if params.reads_guides(level)]
        last = max(needed, default=-1)
        if params.scale_space and params.means == "mip" and needed:
            last += params.depth - 1
        for level in range(last):
            coarse = self.guides[level + 1]
            with using_threads(1 if coarse.height * coarse.width < _FEW_PIXELS else None):
                passes.make_halve(lanes)(self.guides[level], coarse)
        if params.scale_space:
            for level in needed:
                records = self.guide_records[level]
                layout.make_records(self.guides, level, params.step, records, lanes)

    def set_labels(
        self, labels: NDArray[np.uint8] | None, has_label: list[NDArray[np.bool_]]
    ) -> None:
        """(height, width) or None; ``has_label`` says which the source has at each level."""
        params, passes = self.layout.params, self.layout.passes
        for level in range(params.levels):
            if labels is None:
                self.labels[level] = np.zeros((0, 0), np.int16)
                continue
            if self.labels[level].shape != self.grids[level]:
                self.labels[level] = np.zeros(self.grids[level], np.int16)
            passes.decimate_labels(labels, level, params.step, self.labels[level])
            passes.free_lost_labels(self.labels[level], has_label[level])

    def picture_changed(self, level: int) -> None:
        """Make the records of B' at a level."""
        layout, params = self.layout, self.layout.params
        if not params.scale_space:
            return
        if params.means == "mip":
            for coarse in range(level + 1, level + params.depth):
                layout.passes.make_halve(STYLE_LANES)(
                    self.picture[coarse - 1], self.picture[coarse]
                )
        records = self.picture_records[level]
        layout.make_records(self.picture, level, params.step, records, STYLE_LANES)

    def read_at(self, level: int, layout: Layout) -> tuple[Image, Image, int]:
        """Guides and style that the search of a level reads by the parameters of a layout.

        Pixels from entry to entry come third.
        """
        params = layout.params
        if params.scale_space:
            style, guides, spacing = self.picture_records[level], self.guide_records[level], 1
        else:
            style, guides, spacing = self.picture[level], self.guides[level], params.step
        return (guides if params.reads_guides(level) else style), style, spacing
