"""What a level does (algorithms 4 and 5): begin with the level above, then search and blend."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.vector_patch import STYLE_LANES, row_lanes
from stylit_ref.randomness.random_stream import REALTIME_NNF, REALTIME_SEARCH, random_stream
from stylit_ref.realtime.exemplar import Exemplar
from stylit_ref.realtime.formulae.feature_distance import alike_where_free, check_sum, lane_weights
from stylit_ref.realtime.layout import Layout
from stylit_ref.realtime.passes.moving import ALL
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
    guides_alone : (n,) int16
        The same for μ = 0, at the level from which a warm frame renews matches.

    Raises
    ------
    InputError
        If the weights are too large.
    """

    layout: Layout
    weights: tuple[int, ...]
    by_level: list[NDArray[np.int16]] = field(init=False)
    guides_alone: NDArray[np.int16] = field(init=False)

    def __post_init__(self) -> None:
        params = self.layout.params
        by_level = [self._row(level, params.mu_at(level)) for level in range(params.levels)]
        object.__setattr__(self, "by_level", by_level)
        object.__setattr__(self, "guides_alone", self._row(params.renewed_from, 0))

    def _row(self, level, mu):
        layout = self.layout
        rows, pixels = layout.patch_shape
        lanes = layout.lanes_read(level)
        pixel = lane_weights(mu, self.weights, layout.params.terms, lanes)
        check_sum(pixel, rows * pixels)
        row = np.zeros(row_lanes(pixels, lanes), np.int16)
        row[: pixels * lanes] = np.tile(alike_where_free(pixel, layout.channels), pixels)
        return row

    @property
    def first_level_of_guides_alone(self) -> int:
        """From this level upwards the style plays no part."""
        params = self.layout.params
        level = params.levels
        while level > 0 and not params.reads_style(level - 1):
            level -= 1
        return max(level, 1)


class Refinements(NamedTuple):
    """Energies of cold frames and of warm ones."""

    cold: Refinement
    warm: Refinement

    @classmethod
    def of(cls, layout: Layout, weights: tuple[int, ...]) -> "Refinements":
        """Those of a layout; raises as :class:`Refinement` does."""
        warm = replace(layout, params=layout.params.of_warm_frames)
        return cls(Refinement(layout, weights), Refinement(warm, weights))


class Operation(NamedTuple):
    """One of those that make a frame.

    Attributes
    ----------
    name : {"upsample", "blend", "half"}
        Begin a level, blend B', or search half of the entries (figure 20).
    level : int
        0 is the finest.
    iteration : int
        Iterations of the level that are done before it.
    """

    name: Literal["upsample", "blend", "half"]
    level: int
    iteration: int


_FEW_ENTRIES = 100


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
    *,
    settles: bool = False,
) -> None:
    """Do a level's iterations: search both halves, then blend, if a later search reads B'.

    ``nnf`` ends with this level where B' begins with a vote in any case. If the level ``settles``,
    each iteration after the first searches only entries whose match moved in the one before, and
    their neighbours.
    """
    for _ in refining(exemplar, target, refinement, nnf, level, seed, stop, settles=settles):
        pass


def refining(
    exemplar: Exemplar,
    target: Target,
    refinement: Refinement,
    nnf: list[NDArray[np.int32]],
    level: int,
    seed: int,
    stop: NDArray[np.uint8],
    *,
    settles: bool = False,
) -> Iterator[Operation]:
    """What :func:`refine` does, an operation at a time.

    Yields
    ------
    Operation
        What comes next; it is done when the one after it is asked for.
    """
    layout = refinement.layout
    passes, params = layout.passes, layout.params
    search = passes.make_search(*layout.patch_shape, layout.lanes_read(level))
    blend = passes.make_blend(params.patch_width, params.step, STYLE_LANES)
    source, style = exemplar.read_at(level, layout), exemplar.style[level]
    guides, picture, _ = target.read_at(level, layout)
    grid = _grid(exemplar, target, layout, level)
    radius = params.radius_at(level, *exemplar.sizes[level])
    iterations = params.iterations_at(level)
    reads_style = params.reads_style(level)
    if reads_style:
        yield Operation("blend", level, 0)
    if reads_style and (params.start == "vote" or level + 1 == len(nnf)):
        blend(nnf[level], style, target.picture[level], ALL)
    elif reads_style:
        blend(nnf[level + 1], exemplar.style[level + 1], target.picture[level + 1], ALL)
        passes.upsample_picture(target.picture[level + 1], target.picture[level])
    for iteration in range(iterations):
        if reads_style:
            target.picture_changed(level)
        before = nnf[level].copy() if settles and iteration + 1 < iterations else None
        for parity in range(2):
            yield Operation("half", level, iteration)
            stream = random_stream(seed, REALTIME_SEARCH, level, iteration, parity)
            search(
                nnf[level], source, guides, picture, refinement.by_level[level], grid, stream,
                parity, radius, stop,
            )  # fmt: skip
        if stop[0]:
            return
        if before is not None:
            moving = np.empty(target.grids[level], np.uint8)
            passes.mark_moving(before, nnf[level], moving)
            if not moving.any():
                return
            grid = grid._replace(moving=moving)
        if reads_style and iteration + 1 < iterations:
            yield Operation("blend", level, iteration + 1)
            blend(nnf[level], style, target.picture[level], grid.moving)


def renew(
    exemplar: Exemplar,
    target: Target,
    refinement: Refinement,
    nnf: list[NDArray[np.int32]],
    level: int,
) -> None:
    """Renew the matches of level 0 that have grown old, from those of a coarser level."""
    layout = refinement.layout
    guides, picture, _ = target.read_at(level, layout)
    layout.passes.make_renew(*layout.patch_shape, layout.lanes_read(level))(
        nnf[0], nnf[level], level, exemplar.read_at(level, layout), guides, picture,
        refinement.guides_alone, _grid(exemplar, target, layout, level), *exemplar.size,
        _grid(exemplar, target, layout, 0),
    )  # fmt: skip


def _grid(exemplar, target, layout, level):
    labels = target.labels[level], exemplar.labels[level]
    return Grid(layout.params.step, target.read_at(level, layout)[2], layout.margin, *labels)
