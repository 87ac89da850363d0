"""Texture synthesis that a caller drives: any parameter may change between two iterations."""

import logging
from collections.abc import Sequence
from functools import cached_property

import numba
import numpy as np
from numpy.typing import NDArray

from stylit_ref.notes import note
from stylit_ref.randomness.random_stream import GRID, PATCHES, WHITE_NOISE, random_stream
from stylit_ref.randomness.seed import check_seed
from stylit_ref.texture.beginning import begin_with_noise, noise_of
from stylit_ref.texture.cells import cells_on, grid_cells, largest_radius
from stylit_ref.texture.checks import (
    check_coordinates,
    check_exemplar,
    check_guides,
    check_labels,
    check_lock,
    check_memory,
    check_size,
)
from stylit_ref.texture.exemplars import Exemplars, make_exemplars, packed_planes
from stylit_ref.texture.fitting import fit, make_settings
from stylit_ref.texture.formulae.deformation import PHASES, power_table
from stylit_ref.texture.formulae.guide_cost import fixed_guide_weight
from stylit_ref.texture.formulae.polar import Polar
from stylit_ref.texture.formulae.seam_cost import ONE
from stylit_ref.texture.iteration import Iteration, Offered
from stylit_ref.texture.label_maps import FREE_BAND, with_free_borders
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.passes.guide_costs import guide_costs
from stylit_ref.texture.passes.layout import (
    FREE_BELOW,
    FREE_RIGHT,
    LOCKED,
    Settings,
    Sources,
    Texture,
    Workspace,
    make_workspace,
)
from stylit_ref.texture.passes.placement import DEFORMED, PREDICATES, UNTRIED, iterate
from stylit_ref.texture.passes.seam_maps import seam_maps


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
    start : (height, width, 3) int32, optional
        Coordinates to begin with, as :attr:`coordinates` gives them; white noise by default.
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
    texture : Texture
        S as the passes hold it.

    Raises
    ------
    InputError
        If arrays or parameters do not fit together.
    """

    exemplars: Exemplars
    params: TextureParams
    seed: int
    cost: int
    iteration: int
    texture: Texture

    def __init__(
        self,
        exemplars: Sequence[NDArray[np.uint8]],
        size: tuple[int, int],
        params: TextureParams | None = None,
        *,
        seed: int = 0,
        known: Sequence[NDArray[np.bool_] | None] | None = None,
        start: NDArray[np.int32] | None = None,
        lock: NDArray[np.bool_] | None = None,
        labels: NDArray[np.uint8] | None = None,
        free_band: int = FREE_BAND,
        wraps: bool = True,
        source_guides: Sequence[NDArray[np.uint8]] | None = None,
        target_guide: NDArray[np.uint8] | None = None,
    ) -> None:
        check_seed(seed)
        height, width = check_size(size)
        check_memory((height, width))
        self.params = TextureParams() if params is None else params
        largest = largest_radius((height, width))
        self.seed, self.iteration = seed, 0
        self._known = known
        self.exemplars = self._lay_out(exemplars, self.params, _has_fractions(self.params))
        self._source_guides, guide = check_guides(
            source_guides, target_guide, self.exemplars.images, (height, width)
        )
        self._fit = self._work = None
        labels = check_labels(labels, self.exemplars.images, (height, width))
        locked = check_lock(lock, (height, width))
        self._free = np.flatnonzero(locked == 0) if locked.any() else None
        if not wraps:
            locked[:, -1] |= FREE_RIGHT
            locked[-1] |= FREE_BELOW
        self._has_lock = bool(locked.any() or labels.any())
        addresses = np.empty((height, width), np.int32)
        if start is None:
            begin_with_noise(addresses, self.exemplars, labels, seed)
        else:
            start = check_coordinates(start, self.exemplars.images, (height, width))
            if (start[..., 1:] % PHASES).any() and not self.exemplars.fractions:
                self.exemplars = self._lay_out(self.exemplars.images, self.params, True)
            addresses[:] = self.exemplars.addresses(start)
        seams = np.empty((2, height, width), np.int32)
        labels = with_free_borders(labels, free_band)
        self.texture = Texture(addresses, *seams, locked, labels, guide)
        self.fitted(min(self.params.radius, largest))
        if self.params.radius > largest:
            note(
                f"is {self.params.radius}, but {largest} is used: the texture has {width} x "
                f"{height} pixels",
                parameter="radius",
                level=logging.WARNING,
            )
        self._count()

    @property
    def size(self) -> tuple[int, int]:
        """Height and width."""
        height, width = self.texture.addresses.shape
        return height, width

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

    def recount(self) -> int:
        """The cost of S, computed anew; :attr:`cost` equals it after every iteration."""
        running = self.cost
        self._count()
        self.cost, counted = running, self.cost
        return counted

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
        return Iteration(
            number=self.iteration,
            radius=offered.radius,
            max_deformation=offered.max_deformation,
            cells=len(offered.cells),
            tried=int(np.count_nonzero(offered.outcomes != UNTRIED)),
            accepted=int(np.count_nonzero(offered.accepted)),
            deformed=int(np.count_nonzero(offered.outcomes == DEFORMED)),
            cost=self.cost / ONE,
        )

    def paint(self, mask: NDArray[np.bool_], exemplar: int, iterations: int = 4) -> list[Iteration]:
        """Paint with an exemplar: what is white becomes a hole, and is filled at once.

        The cost may rise; all other pixels stay as they are. A session with labels remembers the
        new ones.

        Parameters
        ----------
        mask : (height, width) bool
            Where the brush was. Locked pixels are left out.
        exemplar : int
            Its number, from 1.
        iterations : int
            How many to do at once; patches are of the session's radius.

        Returns
        -------
        list of Iteration

        Raises
        ------
        InputError
            If the mask has another size, or there is no such exemplar.
        """
        mask = check_lock(mask, self.size, "mask") & ~self.texture.lock & LOCKED
        label = check_exemplar(exemplar, self.exemplars.images)
        painted = np.flatnonzero(mask)
        if not painted.size:
            return []
        texture, free, has_lock = self.texture, self._free, self._has_lock
        noise = noise_of(self.exemplars, label, painted.size, self._stream(WHITE_NOISE))
        texture.addresses.ravel()[painted] = noise
        if texture.labels.size > 1:
            texture.labels.ravel()[painted] = label
        self._free, self._has_lock = painted, True
        self.texture = texture._replace(
            lock=texture.lock | (mask ^ LOCKED),
            labels=np.zeros(self.size, np.uint8) if texture.labels.size == 1 else texture.labels,
        )
        try:
            self._count()
            return [self.step() for _ in range(iterations)]
        finally:
            self.texture, self._free, self._has_lock = texture, free, has_lock

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
        params = self.params
        radius = min(params.radius_at(self.iteration), largest_radius(self.size))
        polar, sources, settings = self.fitted(radius)
        settings = settings._replace(predicate=PREDICATES.index(predicate))
        cells = self._cells(radius)
        number = len(cells)
        patches = np.empty((number, polar.radius_at.size), np.int32)
        outcomes, changes = np.empty(number, np.int64), np.empty(number, np.int64)
        iterate(
            texture, sources, polar, power_table(params.gamma), settings,
            self.workspace(polar, settings), self._stream(PATCHES), cells, patches, outcomes,
            changes,
        )  # fmt: skip
        return Offered(cells, patches, outcomes, changes, polar, radius, settings.max_shift)

    def fitted(self, radius: int) -> tuple[Polar, Sources, Settings]:
        """What the passes need for patches of a radius."""
        params = self.params
        key = radius, params.radial_samples, params.angular_samples, params.weighting
        if self._fit is None or self._fit.key != key:
            self._fit = fit(self.exemplars, self._guide_colours, key)
        polar = self._fit.polar
        settings = make_settings(
            params, self.exemplars, self._fit.limits, radius,
            min(params.deformation_at(self.iteration), polar.cosine.size // 4),
            has_lock=self._has_lock, has_labels=self.texture.labels.size > 1,
            guide_weight=self._guide_weight(),
        )  # fmt: skip
        return polar, self._fit.sources, settings

    def workspace(self, polar: Polar, settings: Settings) -> Workspace:
        """Room for the passes to compute in; that of the last patches is kept."""
        jump, shift, threads = settings.max_jump, settings.max_shift, numba.get_num_threads()
        key = polar.inside.shape, polar.radius_at.size, jump, shift, threads
        if self._work is None or self._work[0] != key:
            self._work = key, make_workspace(polar, jump, shift, threads)
        return self._work[1]

    def _cells(self, radius):
        stream = self._stream(GRID)
        if self._free is None:
            return grid_cells(self.size, radius, stream)
        return cells_on(self._free, self.seams, radius, stream)

    def _stream(self, purpose):
        high, low = divmod(self.iteration, 1 << 16)
        return random_stream(self.seed, purpose, vote=high, iteration=low)

    @cached_property
    def _guide_colours(self):
        if self._source_guides is None:
            return np.zeros(1, np.int32)
        return packed_planes(self._source_guides, self.exemplars.border, self.exemplars.fractions)

    def _guide_weight(self):
        return 0 if self._source_guides is None else fixed_guide_weight(self.params.guide_weight)

    def _count(self):
        texture, weight = self.texture, self._guide_weight()
        seam_maps(
            texture.addresses, self.exemplars.colours, self.exemplars.stride,
            self.params.eta, self.params.exponent, texture.seams_x, texture.seams_y,
        )  # fmt: skip
        texture.seams_x[texture.lock & FREE_RIGHT > 0] = 0
        texture.seams_y[texture.lock & FREE_BELOW > 0] = 0
        self.cost = int(texture.seams_x.sum(dtype=np.int64) + texture.seams_y.sum(dtype=np.int64))
        if weight:
            costs = np.empty(self.size, np.int64)
            guide_costs(texture.addresses, self._guide_colours, texture.guide, weight, costs)
            self.cost += int(costs.sum())

    def _lay_out(self, images, params, fractions):
        return make_exemplars(images, params.radius, known=self._known, fractions=fractions)

    def _change(self, params):
        exemplars = self.exemplars
        fractions = exemplars.fractions or _has_fractions(params)
        if params.radius > exemplars.largest_radius or fractions != exemplars.fractions:
            exemplars = self._lay_out(exemplars.images, params, fractions)
        exemplars.centres(min(params.radius, largest_radius(self.size)))  # or InputError
        before, self.params = self.params, params
        if exemplars is not self.exemplars:
            coordinates = self.coordinates
            self.exemplars = exemplars
            self.__dict__.pop("_guide_colours", None)
            self._fit = None
            self.texture.addresses[:] = exemplars.addresses(coordinates)
        counted = "eta", "exponent", "guide_weight"
        if any(getattr(params, name) != getattr(before, name) for name in counted):
            self._count()


def _has_fractions(params):
    return params.max_deformation > 0 and not params.whole_pixels
