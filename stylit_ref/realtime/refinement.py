"""What a level does (algorithms 4 and 5): begin with the level above, then search and blend."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.vector_patch import STYLE_LANES, row_lanes
from stylit_ref.randomness.random_stream import REALTIME_NNF, REALTIME_SEARCH, random_stream
from stylit_ref.realtime.exemplar import Exemplar
from stylit_ref.realtime.formulae.feature_distance import check_sum, lane_weights
from stylit_ref.realtime.layout import Layout
from stylit_ref.realtime.passes.search import Grid
from stylit_ref.realtime.target import Target


@dataclass(frozen=True)
class Refinement:
    """The energy of every level.

    Attributes
    ----------
    layout : Layout
    weights : tuple of int
        Of the channels of the guides.
    by_level : list of (n,) int16
        Of the bytes of a row of a patch.

    Raises
    ------
    InputError
        If the weights are too large.
    """

    layout: Layout
    weights: tuple[int, ...]
    by_level: list[NDArray[np.int16]] = field(init=False)

    def __post_init__(self) -> None:
        layout, params = self.layout, self.layout.params
        rows, pixels = layout.patch_shape
        by_level = []
        for level in range(params.levels):
            lanes = layout.lanes_read(level)
            pixel = lane_weights(params.mu_at(level), self.weights, params.terms, lanes)
            check_sum(pixel, rows * pixels)
            row = np.zeros(row_lanes(pixels, lanes), np.int16)
            row[: pixels * lanes] = np.tile(pixel, pixels)
            by_level.append(row)
        object.__setattr__(self, "by_level", by_level)

    @property
    def first_level_of_guides_alone(self) -> int:
        """From this level upwards the style plays no part."""
        params = self.layout.params
        level = params.levels
        while level > 0 and not params.reads_style(level - 1):
            level -= 1
        return max(level, 1)


_FEW_ENTRIES = 1000


def threads_of_level(target: Target, level: int) -> int | None:
    """1 where a grid has so few entries that waking other threads takes longer; None otherwise."""
    rows, columns = target.grids[level]
    return 1 if rows * columns < _FEW_ENTRIES else None


def start_level(exemplar: Exemplar, nnf: list[NDArray[np.int32]], level: int, seed: int) -> None:
    """Fill the NNF of a level: from the level above, or at random on the coarsest."""
    layout = exemplar.layout
    passes, params = layout.passes, layout.params
    size = exemplar.sizes[level]
    if level == params.levels - 1:
        stream = random_stream(seed, REALTIME_NNF, level)
        passes.random_nnf(nnf[level], *size, layout.margin, stream)
    else:
        passes.upsample_nnf(nnf[level + 1], nnf[level], *size, layout.margin, params.step)


def refine(
    exemplar: Exemplar,
    target: Target,
    refinement: Refinement,
    nnf: list[NDArray[np.int32]],
    level: int,
    seed: int,
    stop: NDArray[np.uint8],
) -> None:
    """Do a level's iterations: search both halves, then blend, if a later search reads B'."""
    layout = exemplar.layout
    passes, params = layout.passes, layout.params
    search = passes.make_search(*layout.patch_shape, layout.lanes_read(level))
    blend = passes.make_blend(params.patch_width, params.step, STYLE_LANES)
    source, style = exemplar.read_at(level), exemplar.style[level]
    guides, picture, spacing = target.read_at(level)
    grid = Grid(params.step, spacing, layout.margin, target.labels[level], exemplar.labels[level])
    radius = params.radius_at(level, *exemplar.sizes[level])
    iterations = params.iterations_at(level)
    reads_style = params.reads_style(level)
    if reads_style and (params.start == "vote" or level + 1 == params.levels):
        blend(nnf[level], style, target.picture[level])
    elif reads_style:
        blend(nnf[level + 1], exemplar.style[level + 1], target.picture[level + 1])
        passes.upsample_picture(target.picture[level + 1], target.picture[level])
    for iteration in range(iterations):
        if reads_style:
            target.picture_changed(level)
        for parity in range(2):
            stream = random_stream(seed, REALTIME_SEARCH, level, iteration, parity)
            search(
                nnf[level], source, guides, picture, refinement.by_level[level], grid, stream,
                parity, radius, stop,
            )  # fmt: skip
        if stop[0]:
            return
        if reads_style and iteration + 1 < iterations:
            blend(nnf[level], style, target.picture[level])
