"""What the passes are given: tables and sources for one radius, and the numbers they go by."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stylit_ref.texture.exemplars import Exemplars
from stylit_ref.texture.formulae.polar import CostLimits, Polar, cost_limits, make_polar
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.passes.candidates import ring
from stylit_ref.texture.passes.layout import Settings, Sources
from stylit_ref.texture.passes.placement import PREDICATES


@dataclass(frozen=True)
class Fitted:
    """What depends on the radius of patches, and the ``key`` that it was made for."""

    key: tuple[int, float, float, str]
    polar: Polar
    limits: CostLimits
    sources: Sources


def fit(
    exemplars: Exemplars, guide_colours: NDArray[np.int32], key: tuple[int, float, float, str]
) -> Fitted:
    """Make the tables of T and the sources of patches.

    Parameters
    ----------
    exemplars : Exemplars
    guide_colours : (n,) int32
        Their guides, laid out as they are; (1,) without.
    key : tuple
        The parameters of :func:`stylit_ref.texture.formulae.polar.make_polar`.
    """
    radius = key[0]
    centres = exemplars.centres(radius)
    sources = Sources(
        colours=exemplars.colours,
        guide_colours=guide_colours,
        clearance=exemplars.clearance.ravel(),
        centres=centres,
        bounds=exemplars.bounds,
        centre_bounds=np.searchsorted(centres, exemplars.bounds),
        ring=ring(radius),
        prices=np.zeros(exemplars.plane, np.int64),
    )
    polar = make_polar(*key)
    return Fitted(key, polar, cost_limits(polar), sources)


def make_settings(
    params: TextureParams,
    exemplars: Exemplars,
    limits: CostLimits,
    radius: int,
    shift: int,
    *,
    has_lock: bool,
    has_labels: bool,
    guide_weight: int,
) -> Settings:
    """The numbers of an iteration with patches of ``radius`` and deformations up to ``shift``."""
    return Settings(
        stride=exemplars.stride,
        plane=exemplars.plane,
        radius=radius,
        max_jump=params.max_jump,
        max_shift=shift,
        eta=params.eta,
        exponent=params.exponent,
        new_limit=limits.new,
        existing_limit=limits.existing,
        hidden_limit=limits.hidden,
        penalty=params.shift_penalty,
        fractions=int(exemplars.fractions and not params.whole_pixels),
        predicate=PREDICATES.index(params.predicate),
        second_pass=int(params.second_pass),
        prescreened=params.candidates,
        spread=params.spread,
        coherence=round(params.coherence * 65536),
        tries=params.tries,
        has_lock=int(has_lock),
        has_labels=int(has_labels),
        guide_weight=guide_weight,
    )
