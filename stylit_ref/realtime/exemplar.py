"""The source as the search reads it: guides A and style A' on all levels."""

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.replaced import Passes
from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.realtime.formulae.grid import first_centre, last_centre
from stylit_ref.realtime.layout import Layout
from stylit_ref.realtime.passes.image import Image, make_image


def labels_in(labels: NDArray[np.uint8], passes: Passes) -> NDArray[np.bool_]:
    """Which labels (height, width) pixels have, (256,)."""
    there = np.zeros(256, np.bool_)
    passes.mark_labels(labels, there)
    return there


class Exemplar:
    """A and A'. They change apart: each keeps what does not depend on the other.

    Parameters
    ----------
    height, width : int
    layout : Layout

    Attributes
    ----------
    size : tuple of int
    sizes : list of tuple of int
        By level.
    style : list of Image
        A' by level.
    both : list of Image
        A by level, with room for A' in the last four bytes of a pixel.
    records : list of Image
        Records of the scale space by level, of both or of the style alone; empty without it.
    labels : list of (height, width) uint8
        By level; arrays of no pixels if there are none.
    has_label : list of (256,) bool
        By level, which labels a centre has.
    own_labels : (256,) bool or None
        Which labels there are at all; None if none were given.
    """

    layout: Layout
    size: tuple[int, int]
    sizes: list[tuple[int, int]]
    style: list[Image]
    both: list[Image]
    labels: list[NDArray[np.uint8]]

    def __init__(self, height: int, width: int, layout: Layout) -> None:
        self.layout = layout
        self.size = height, width
        self.sizes = sizes = layout.sizes(height, width)
        self.style = [make_image(*size, layout.border, STYLE_LANES) for size in sizes]
        self.both = [make_image(*size, layout.border, layout.lanes) for size in sizes]
        self._joined: set[int] = set()
        self.records: list[Image] = []
        if layout.params.scale_space:
            self.records = [
                make_image(*sizes[level], 0, layout.unit(level))
                for level in range(layout.params.levels)
            ]
        self.labels = [np.zeros((0, 0), np.uint8)] * layout.params.levels
        self.has_label: list[NDArray[np.bool_]] = []
        self.own_labels: NDArray[np.bool_] | None = None

    def set_guides(self, guides: NDArray[np.uint8]) -> None:
        """A, (height, width, channels)."""
        passes, lanes = self.layout.passes, self.layout.lanes
        passes.make_fill(self.layout.channels, lanes)(guides.reshape(-1), self.both[0])
        self._halve(self.both, lanes)

    def set_style(self, style: NDArray[np.uint8]) -> None:
        """A', (height, width, 3)."""
        self.layout.passes.make_fill(3, STYLE_LANES)(style.reshape(-1), self.style[0])
        self._halve(self.style, STYLE_LANES)

    def join(self) -> None:
        """Put A' beside A, and make the records of both; to be called after a change of either."""
        layout = self.layout
        params = layout.params
        mips = params.depth - 1 if params.scale_space and params.means == "mip" else 0
        self._joined = set()
        for level in range(len(self.both)):
            if any(
                params.reads_guides(below)
                for below in range(max(level - mips, 0), min(level + 1, params.levels))
            ):
                self.join_level(level)
        for level, records in enumerate(self.records):
            pixels = self.both if params.reads_guides(level) else self.style
            layout.make_records(pixels, level, 1, records, layout.lanes_read(level))

    def join_level(self, level: int) -> None:
        """Put A' beside A at a level, if that is not done; warm frames read more levels."""
        if level in self._joined:
            return
        image = self.style[level]
        rows = image.height + 2 * image.border
        self.layout.passes.make_insert_style(self.layout.lanes)(image, self.both[level], 0, rows)
        self._joined.add(level)

    def set_labels(self, labels: NDArray[np.uint8] | None) -> None:
        """(height, width), or None."""
        self.labels, self.has_label = [], []
        self.own_labels = None if labels is None else labels_in(labels, self.layout.passes)
        for level in range(self.layout.params.levels):
            step = 1 << level
            if labels is None:
                self.labels.append(np.zeros((0, 0), np.uint8))
                continue
            there = np.ascontiguousarray(labels[::step, ::step])
            centres = tuple(
                slice(
                    first_centre(side, self.layout.margin),
                    last_centre(side, self.layout.margin) + 1,
                )
                for side in there.shape
            )
            present = np.zeros(256, np.bool_)
            present[np.unique(there[centres])] = True
            self.labels.append(there)
            self.has_label.append(present)

    def read_at(self, level: int, layout: Layout) -> Image:
        """What the search of a level reads by the parameters of a layout."""
        if self.records:
            return self.records[level]
        if layout.params.reads_guides(level):
            self.join_level(level)
            return self.both[level]
        return self.style[level]

    def _halve(self, images, lanes):
        for fine, coarse in pairwise(images):
            self.layout.passes.make_halve(lanes)(fine, coarse)
