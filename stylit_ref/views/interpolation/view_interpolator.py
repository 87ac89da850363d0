"""Pictures of places between the views of a grid, in each of the ways of chapter 3.3."""

from collections.abc import Callable
from functools import cached_property
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.views.interpolation import passes
from stylit_ref.views.interpolation.formulae.weights import WHOLE
from stylit_ref.views.interpolation.grid import Around, Grid
from stylit_ref.views.interpolation.painting import (
    make_style,
    pixels_of,
    search_among,
    vote,
)
from stylit_ref.views.interpolation.surface import Geometry

Mode = Literal["linear", "image", "blend", "nnf", "limited", "fade"]
"""``linear`` blends the pictures of the views around, ``image`` shifts that of the closest and
fills what it hides from the others, ``blend`` blends all shifted ones (3.3.1). ``nnf`` shifts NNFs
and votes, ``limited`` adds the limited search (3.3.2). ``fade`` lets frames of ``limited`` fade
into each other where the closest view changes."""

MODES: tuple[Mode, ...] = get_args(Mode)

BAND = 0.4
"""How wide the fade is, as a part of the way from view to view."""


class Stylized(NamedTuple):
    """What is known of the style of a grid's views.

    Attributes
    ----------
    style : (H_A, W_A, n) uint8
    patch_width : int
    nnfs : (N, H, W) int32
        Packed; the patches lie within the style.
    pictures : (N, H, W, n) uint8
    """

    style: NDArray[np.uint8]
    patch_width: int
    nnfs: NDArray[np.int32]
    pictures: NDArray[np.uint8]


class Shifted(NamedTuple):
    """Where the pixels of a view lie in the views around it.

    Attributes
    ----------
    around : Around
    views : (K,) int64
        The views around, the closest first.
    places : (K, H, W) int32
        Of :func:`stylit_ref.views.interpolation.passes.shift`.
    """

    around: Around
    views: NDArray[np.int64]
    places: NDArray[np.int32]


class ViewInterpolator:
    """Makes pictures of places between the views of a grid.

    Parameters
    ----------
    grid : Grid
    geometry : Geometry
    stylized : Stylized
    band : float, optional
        How wide the fade is, as a part of the way from view to view.
    """

    grid: Grid
    geometry: Geometry
    stylized: Stylized
    band: float

    def __init__(
        self, grid: Grid, geometry: Geometry, stylized: Stylized, band: float = BAND
    ) -> None:
        self.grid, self.geometry, self.stylized, self.band = grid, geometry, stylized, band
        self._style = make_style(stylized.style, stylized.patch_width)

    def picture(self, place: tuple[float, float], mode: Mode = "fade") -> NDArray[np.uint8]:
        """The picture of a place.

        Parameters
        ----------
        place : tuple of 2 float
            To the right and upwards, from the middle of the grid, in degrees; in steps where the
            grid counts them.
        mode : {"linear", "image", "blend", "nnf", "limited", "fade"}, optional

        Returns
        -------
        (H, W, n) uint8

        Raises
        ------
        InputError
            If the place lies outside of the grid, or there is no such mode.
        """
        if mode not in MODES:
            raise InputError(f"is {mode!r}; choose one of {', '.join(MODES)}", parameter="mode")
        self.grid.check(place)
        make: dict[str, Callable[[tuple[float, float]], NDArray[np.uint8]]] = {
            "linear": self._linear,
            "image": self._image,
            "blend": self._blend,
            "nnf": lambda place: self._painted(self.shift(place), search=False),
            "limited": lambda place: self._painted(self.shift(place)),
            "fade": self._fade,
        }
        return make[mode](place)

    def shift(self, place: tuple[float, float]) -> Shifted:
        """Find where each pixel of a place's view lies in the views around it.

        Parameters
        ----------
        place : tuple of 2 float

        Returns
        -------
        Shifted
        """
        around = self.grid.around(place, self.band)
        surface, motion = self.geometry.look(place, around.views)
        views, places = np.array(around.views, np.int64), np.empty(motion.shape[:3], np.int32)
        passes.shift(motion, surface.labels, surface.beside, self._labels, views, places)
        return Shifted(around, views, places)

    def fetch(self, shifted: Shifted) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """Shift the NNFs of the views around.

        Parameters
        ----------
        shifted : Shifted

        Returns
        -------
        candidates : (K, H, W) int32
            Packed entries, -1 where they are masked.
        nnf : (H, W) int32
            The chosen entries.
        """
        candidates = np.empty_like(shifted.places)
        nnf = np.empty(shifted.places.shape[1:], np.int32)
        nnfs = self.stylized.nnfs
        passes.fetch(nnfs, shifted.views, shifted.places, candidates, nnf)
        return candidates, nnf

    @cached_property
    def _labels(self):
        return self.geometry.view_labels()

    def _linear(self, place):
        around = self.grid.around(place, self.band)
        return self._mixed(self.stylized.pictures[list(around.views)], around.linear)

    def _image(self, place):
        shifted = self.shift(place)
        others = [0] * (len(shifted.views) - 1)
        return self._mix_shifted(shifted, [WHOLE, *others])

    def _blend(self, place):
        shifted = self.shift(place)
        return self._mix_shifted(shifted, shifted.around.linear)

    def _fade(self, place):
        shifted = self.shift(place)
        weights = [weight for weight in shifted.around.fading if weight]
        frames = [
            self._painted(_led_by(shifted, k))
            for k, weight in enumerate(shifted.around.fading)
            if weight
        ]
        return frames[0] if len(frames) == 1 else self._mixed(np.stack(frames), weights)

    def _painted(self, shifted, search=True):
        candidates, nnf = self.fetch(shifted)
        picture = vote(self._style, nnf)
        if search:
            picture = vote(self._style, search_among(self._style, nnf, candidates, picture))
        return pixels_of(picture, self._style.channels)

    def _mixed(self, pictures, weights):
        mixed = np.empty_like(pictures[0])
        passes.mix(pictures, np.array(weights, np.int64), mixed)
        return mixed

    def _mix_shifted(self, shifted, weights):
        pictures = self.stylized.pictures
        mixed = np.empty(pictures.shape[1:], np.uint8)
        weights = np.array(weights, np.int64)
        passes.mix_shifted(pictures, shifted.views, shifted.places, weights, mixed)
        return mixed


def _led_by(shifted: Shifted, first: int) -> Shifted:
    """The same views, with another one first."""
    order = [first, *(k for k in range(len(shifted.views)) if k != first)]
    return shifted._replace(views=shifted.views[order], places=shifted.places[order])
