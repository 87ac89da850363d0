"""What patches are taken from: exemplars with their guides, laid out for some parameters."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from stylit_ref.texture.exemplars import Exemplars, make_exemplars, packed_planes
from stylit_ref.texture.formulae.guide_cost import fixed_guide_weight
from stylit_ref.texture.params import TextureParams


@dataclass(frozen=True, eq=False)
class Stock:
    """What patches are taken from.

    Attributes
    ----------
    exemplars : Exemplars
    known : sequence of (H, W) bool or None, optional
        Which pixels of each may be copied.
    guides : sequence of (H, W, c) uint8, optional
        A guide of each.
    """

    exemplars: Exemplars
    known: Sequence[NDArray[np.bool_] | None] | None
    guides: Sequence[NDArray[np.uint8]] | None = None

    @cached_property
    def guide_colours(self) -> NDArray[np.int32]:
        """The guides, laid out as the exemplars are; one 0 without."""
        if self.guides is None:
            return np.zeros(1, np.int32)
        return packed_planes(self.guides, self.exemplars.border, self.exemplars.fractions)

    def guide_weight(self, params: TextureParams) -> int:
        """The fixed-point weight of the guide; 0 without one."""
        return 0 if self.guides is None else fixed_guide_weight(params.guide_weight)

    def suiting(self, params: TextureParams, fractions: bool = False) -> "Stock":
        """The stock itself, or one that is laid out anew where parameters ask for more.

        Parameters
        ----------
        params : TextureParams
            A larger radius asks for a wider border, deformation for quarters of a pixel.
        fractions : bool
            Whether these are asked for in any case.
        """
        now = self.exemplars
        fractions = fractions or now.fractions or _has_fractions(params)
        if params.radius <= now.largest_radius and fractions == now.fractions:
            return self
        exemplars = make_exemplars(now.images, params.radius, known=self.known, fractions=fractions)
        return replace(self, exemplars=exemplars)


def make_stock(
    images: Sequence[NDArray[np.uint8]],
    params: TextureParams,
    known: Sequence[NDArray[np.bool_] | None] | None,
) -> Stock:
    """A stock without guides.

    Raises
    ------
    InputError
        As :func:`stylit_ref.texture.exemplars.make_exemplars`.
    """
    fractions = _has_fractions(params)
    return Stock(make_exemplars(images, params.radius, known=known, fractions=fractions), known)


def _has_fractions(params):
    return params.max_deformation > 0 and not params.whole_pixels
