"""Texture synthesis that a caller drives: any parameter may change between two iterations."""

import logging
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace

import numba
import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.texture_field import TextureField
from stylit_ref.notes import note
from stylit_ref.randomness.philox import FourWords
from stylit_ref.randomness.random_stream import GRID, PATCHES, random_stream
from stylit_ref.randomness.seed import check_seed
from stylit_ref.texture.beginning import begin_with_noise
from stylit_ref.texture.canvas import Canvas, make_canvas
from stylit_ref.texture.cells import largest_radius
from stylit_ref.texture.checks import (
    check_coordinates,
    check_exemplar_sizes,
    check_guides,
    check_labels,
    check_lock,
    check_memory,
    check_size,
)
from stylit_ref.texture.exemplars import Exemplars, make_field
from stylit_ref.texture.fitting import fit, make_settings
from stylit_ref.texture.formulae.deformation import PHASES, power_table
from stylit_ref.texture.formulae.polar import Polar
from stylit_ref.texture.iteration import Iteration, Offered, told
from stylit_ref.texture.label_maps import FREE_BAND
from stylit_ref.texture.params import TextureParams, as_texture_params
from stylit_ref.texture.passes.layout import (
    Settings,
    Sources,
    Texture,
    Workspace,
    make_workspace,
)
from stylit_ref.texture.passes.placement import PREDICATES, iterate
from stylit_ref.texture.stock import Stock, make_stock


class TextureSession:
    """S, and iterations that improve it (sections 3 to 6).

    Parameters
    ----------
    exemplars : sequence of (H, W) or (H, W, c) uint8
        E, one or several, 1 or 3 channels.
    size : tuple of int
        Height and width of the texture; it wraps around.
    params : TextureParams, optional
        Those of the first iteration, until :meth:`step` gets others.
    seed : int
    known : sequence of (H, W) bool or None, optional
        Which pixels of each exemplar may be copied.
    start : TextureField or (height, width, 3) int32, optional
        What to begin with; white noise by default. A field goes on where it was saved, with as many
        iterations done; coordinates begin anew.
    lock : (height, width) bool, optional
        Pixels that keep what they have at the start.
    labels : (height, width) uint8, optional
        The number of the exemplar, from 1, that each pixel comes from; 0 for any.
    free_band : int
        Within so many pixels of a border between two labels, a pixel may come from any exemplar.
    wraps : bool
        Whether the last row and column continue in the first; otherwise seams there cost nothing.
    source_guides : sequence of (H, W) or (H, W, c) uint8, optional
        A guide for every exemplar, as large as it, 1 or 3 channels.
    target_guide : (height, width) or (height, width, c) uint8, optional
        The guide that the texture shall follow.

    Attributes
    ----------
    cost : int
        What S costs, in units of 1/256 of M: the running total.
    iteration : int
        Iterations done.
    idle : int
        How many of them, up to the last, changed nothing.
    canvas : Canvas
        S, and which of its pixels may change.
    stock : Stock
        What patches are taken from.

    Raises
    ------
    InputError
        If arrays or parameters do not fit together.
    """

    params: TextureParams
    seed: int
    cost: int
    iteration: int
    idle: int
    canvas: Canvas
    stock: Stock

    def __init__(
        self,
        exemplars: Sequence[NDArray[np.uint8]],
        size: tuple[int, int],
        params: TextureParams | None = None,
        *,
        seed: int = 0,
        known: Sequence[NDArray[np.bool_] | None] | None = None,
        start: TextureField | NDArray[np.int32] | None = None,
        lock: NDArray[np.bool_] | None = None,
        labels: NDArray[np.uint8] | None = None,
        free_band: int = FREE_BAND,
        wraps: bool = True,
        source_guides: Sequence[NDArray[np.uint8]] | None = None,
        target_guide: NDArray[np.uint8] | None = None,
    ) -> None:
        check_seed(seed)
        self.params = as_texture_params(params)
        height, width = check_size(size)
        check_memory((height, width), self.params)
        self.seed, self.iteration, self.idle = seed, 0, 0
        stock = make_stock(exemplars, self.params, known)
        images = stock.exemplars.images
        guides, guide = check_guides(source_guides, target_guide, images, (height, width))
        self.stock = replace(stock, guides=guides)
        self._fit = self._work = None
        labels = check_labels(labels, images, (height, width))
        locked = check_lock(lock, (height, width))
        addresses = np.empty((height, width), np.int32)
        if start is None:
            begin_with_noise(addresses, self.exemplars, labels, seed)
        else:
            if isinstance(start, TextureField):
                check_exemplar_sizes(start.exemplar_sizes, images)
                self.iteration, self.idle = start.iterations, start.idle
                start = start.coordinates
            start = check_coordinates(start, images, (height, width))
            has_fractions = bool((start[..., 1:] % PHASES).any())
            self.stock = self.stock.suiting(self.params, fractions=has_fractions)
            addresses[:] = self.exemplars.addresses(start)
        self.canvas = make_canvas(
            addresses, locked, labels, guide, free_band=free_band, wraps=wraps
        )
        largest = largest_radius(self.size)
        self.fitted(min(self.params.radius, largest))
        if self.params.radius > largest:
            note(
                f"is {self.params.radius}, but {largest} is used: the texture has {width} x "
                f"{height} pixels",
                parameter="radius",
                level=logging.WARNING,
            )
        self.cost = self.recount()

    @property
    def size(self) -> tuple[int, int]:
        """Height and width."""
        return self.canvas.size

    @property
    def radius(self) -> int:
        """R of the next patches: smaller than asked for where the texture is too small for it."""
        return min(self.params.radius_at(self.iteration), largest_radius(self.size))

    @property
    def exemplars(self) -> Exemplars:
        """The exemplars as they are laid out for the passes."""
        return self.stock.exemplars

    @property
    def texture(self) -> Texture:
        """S as the passes hold it."""
        return self.canvas.texture

    @property
    def image(self) -> NDArray[np.uint8]:
        """E[S], with the channels of the exemplars."""
        return self.exemplars.show(self.texture.addresses)

    @property
    def coordinates(self) -> NDArray[np.int32]:
        """S: for every pixel the number of its exemplar, and y and x in quarters of a pixel."""
        return self.exemplars.coordinates(self.texture.addresses)

    @property
    def addresses(self) -> NDArray[np.int32]:
        """S as the passes hold it (:class:`stylit_ref.texture.exemplars.Exemplars`)."""
        return self.texture.addresses

    @property
    def seams(self) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """What the edge to the right of each pixel costs, and the edge below it, in 1/256 of M."""
        return self.texture.seams_x, self.texture.seams_y

    @property
    def field(self) -> TextureField:
        """S with the sizes of its exemplars and what was done, to be saved, replayed or resumed."""
        return make_field(self.exemplars, self.addresses, self.iteration, self.idle)

    def recount(self) -> int:
        """The cost of S, computed anew; :attr:`cost` equals it after every iteration."""
        return self.canvas.count(
            self.exemplars,
            self.params,
            self.stock.guide_colours,
            self.stock.guide_weight(self.params),
        )

    def step(self, params: TextureParams | None = None) -> Iteration:
        """Offer every cell of a grid, shifted at random, a patch (section 3).

        Parameters
        ----------
        params : TextureParams, optional
            Those of this iteration and all later ones.

        Returns
        -------
        Iteration
        """
        if params is not None:
            self._change(params)
        offered = self.offer(self.texture, self.params.predicate)
        self.cost += int(offered.changes[offered.accepted].sum())
        self.iteration += 1
        self.idle = 0 if offered.accepted.any() else self.idle + 1
        return told(offered, self.iteration, self.cost)

    @contextmanager
    def working_on(self, canvas: Canvas) -> Iterator[None]:
        """While the block runs, have iterations work on another canvas of the same S."""
        whole, self.canvas = self.canvas, canvas
        try:
            self.cost = self.recount()
            yield
        finally:
            self.canvas = whole

    def offer(self, texture: Texture, predicate: str) -> Offered:
        """Do what an iteration does to ``texture``, and leave all else as it is.

        Parameters
        ----------
        texture : Texture
            Changed in place.
        predicate : {"exact", "after", "before", "none"}

        Returns
        -------
        Offered
        """
        radius = self.radius
        polar, sources, settings = self.fitted(radius)
        settings = settings._replace(predicate=PREDICATES.index(predicate))
        cells = self.canvas.cells(radius, self.stream(GRID))
        number = len(cells)
        patches = np.empty((number, polar.radius_at.size), np.int32)
        outcomes, changes = np.empty(number, np.int64), np.empty(number, np.int64)
        iterate(
            texture, sources, polar, power_table(self.params.gamma), settings,
            self.workspace(polar, settings), self.stream(PATCHES), cells, patches, outcomes,
            changes,
        )  # fmt: skip
        return Offered(cells, patches, outcomes, changes, polar, radius, settings.max_shift)

    def fitted(self, radius: int) -> tuple[Polar, Sources, Settings]:
        """What the passes need for patches of a radius."""
        params = self.params
        key = radius, params.radial_samples, params.angular_samples, params.weighting
        if self._fit is None or self._fit.key != key:
            self._fit = fit(self.exemplars, self.stock.guide_colours, key)
        polar = self._fit.polar
        settings = make_settings(
            params, self.exemplars, self._fit.limits, radius,
            min(params.deformation_at(self.iteration), polar.cosine.size // 4),
            has_lock=self.canvas.has_lock, has_labels=self.canvas.has_labels,
            guide_weight=self.stock.guide_weight(params),
        )  # fmt: skip
        return polar, self._fit.sources, settings

    def workspace(self, polar: Polar, settings: Settings) -> Workspace:
        """Room for the passes to compute in; that of the last patches is kept."""
        jump, shift, threads = settings.max_jump, settings.max_shift, numba.get_num_threads()
        key = polar.inside.shape, polar.radius_at.size, jump, shift, threads
        if self._work is None or self._work[0] != key:
            self._work = key, make_workspace(polar, jump, shift, threads)
        return self._work[1]

    def stream(self, purpose: int) -> FourWords:
        """The random numbers of the next iteration for a purpose."""
        high, low = divmod(self.iteration, 1 << 16)
        return random_stream(self.seed, purpose, vote=high, iteration=low)

    def _change(self, params):
        check_memory(self.size, as_texture_params(params))
        stock = self.stock.suiting(params)
        stock.exemplars.centres(min(params.radius, largest_radius(self.size)))  # or InputError
        before, self.params = self.params, params
        if stock is not self.stock:
            coordinates = self.coordinates
            self.stock, self._fit = stock, None
            self.texture.addresses[:] = self.exemplars.addresses(coordinates)
        counted = "eta", "exponent", "guide_weight"
        if any(getattr(params, name) != getattr(before, name) for name in counted):
            self.cost = self.recount()
