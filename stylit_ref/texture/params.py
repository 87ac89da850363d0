"""Parameters of texture synthesis."""

from dataclasses import dataclass
from typing import Any

from stylit_ref.errors import InputError
from stylit_ref.parameters import Choice, Flag, Integer, Number, Optional, check_fields, parameter
from stylit_ref.texture.formulae.polar import WEIGHTINGS
from stylit_ref.texture.passes.placement import PREDICATES

LARGEST_RADIUS = 1024
LARGEST_ETA = 10_000_000


@dataclass(frozen=True)
class TextureParams:
    """What shapes a texture, apart from the exemplars and the seed (Lasram & Lefebvre 2012).

    Attributes
    ----------
    radius : int
        R, the largest radius of a patch in the first iteration, in pixels. The one that matters
        most: large enough to hold what must stay whole.
    max_deformation : int
        D_max, the largest shift of a colour along a cut, in rows of the polar table; 0 for none.
    radial_samples, angular_samples : float
        N_ρ and N_θ, samples of the polar table a pixel.
    max_jump : int
        J_max, how many columns a cut may move from one row to the next.
    gamma : float
        γ, how deformation fades towards the centre; small values spread it further.
    exponent : int
        d of the seam cost M; 2 or 3 avoid strong seams.
    eta : int
        η of M, in squared 8-bit steps.
    predicate : {"exact", "after", "before", "none"}
        When a patch is rejected (section 6). ``exact``: if the cost of S would not fall.
        ``before``: if its cut costs at least what it hides, in the polar table, before alignment.
        ``after``: if the table says so of the aligned patch, and of the one without deformation.
        ``none``: never.
    weighting : {"arc_length", "printed"}
        How pieces of a cut are weighed (:mod:`stylit_ref.texture.formulae.polar`).
    second_pass : bool
        Whether a cut is looked for in two turns. The second begins with what the first paid to
        arrive, and nearly always finds the best.
    candidates : int
        How many patches are compared with S by a sparse look before the best is cut; 1 is the
        paper's uniform choice.
    spread : int
        How much candidates are preferred whose part of the exemplar S uses little, in squared 8-bit
        steps a pixel that is compared. Without it patches that are easy to fit take over, and what
        is rare in the exemplar vanishes.
    tries : int
        How many of these choices are cut, of which the best stays.
    coherence : float
        The share of candidates that continue what S shows nearby. Pieces grow with it.
    shift_penalty : int
        What each change of the shift from row to row costs, in units of 1/256.
    whole_pixels : bool
        Whether S holds whole pixels only.
    iterations : int
        How many patches every place is offered, about.
    patience : int, optional
        Stop after so many iterations without an acceptance.
    radius_step, radius_end : int
        How much R falls from iteration to iteration, and where it ends. It falls at first, so that
        a few large patches settle the whole; those of one size leave walls and tiles broken.
    deformation_step, deformation_end : int
        The same of D_max.
    guide_weight : float
        What a difference of 255 in one channel of the guide costs, where an exemplar's seam of
        equal contrast costs about 1.
    """

    radius: int = parameter(
        96, Integer(1, LARGEST_RADIUS), "R, largest radius of a patch in pixels, to begin with: "
        "large enough to hold what must stay whole",
    )  # fmt: skip
    max_deformation: int = parameter(
        0,
        Integer(0, 4096),
        "D_max, largest shift along a cut when features are aligned; 0 for none",
    )
    radial_samples: float = parameter(
        2.0, Number(0.25, 8), "N_ρ, samples of a patch a pixel of its radius"
    )
    angular_samples: float = parameter(
        1.5, Number(0.25, 8), "N_θ, samples of a patch a pixel of its border"
    )
    max_jump: int = parameter(
        8, Integer(1, 64), "J_max, how far a cut may jump from one sample to the next"
    )
    gamma: float = parameter(
        1.0, Number(0.01, 100), "γ, how deformation fades inwards; small values spread it further"
    )
    exponent: int = parameter(2, Integer(1, 3), "d, how much strong seams count")
    eta: int = parameter(
        1000,
        Integer(1, LARGEST_ETA),
        "η, contrast in squared 8-bit steps below which all seams count",
    )
    predicate: str = parameter(
        "exact", Choice(PREDICATES), "which patches are rejected: exact, those that do not lower "
        "the cost of the texture; after or before, by an estimate after or before alignment; none",
    )  # fmt: skip
    weighting: str = parameter(
        "arc_length", Choice(WEIGHTINGS), "how a cut is weighed: by its length, or as printed"
    )
    second_pass: bool = parameter(True, Flag(), "improve every cut by a second pass")
    candidates: int = parameter(
        128, Integer(1, 65536), "patches that are compared by a sparse look before the best is cut"
    )
    spread: int = parameter(
        400,
        Integer(0, 65536),
        "how much patches are preferred that the texture uses little so far; 0 for not at all",
    )
    tries: int = parameter(1, Integer(1, 256), "how many patches are cut, of which the best stays")
    coherence: float = parameter(
        0.0, Number(0, 1), "share of candidates that continue what is nearby; pieces grow with it"
    )
    shift_penalty: int = parameter(
        0, Integer(0, 4096), "cost of each change of the shift along a cut, in units of 1/256"
    )
    whole_pixels: bool = parameter(False, Flag(), "deformed patches take whole pixels only")
    iterations: int = parameter(24, Integer(0, 1 << 30), "how often every place is offered a patch")
    patience: int | None = parameter(
        None, Optional(Integer(1, 1 << 30)), "stop after so many iterations without a change"
    )
    radius_step: int = parameter(
        8, Integer(0, LARGEST_RADIUS), "how much R falls from iteration to iteration"
    )
    radius_end: int = parameter(64, Integer(1, LARGEST_RADIUS), "the R at which it stops falling")
    deformation_step: int = parameter(
        0, Integer(0, 4096), "how much D_max falls from iteration to iteration"
    )
    deformation_end: int = parameter(0, Integer(0, 4096), "the D_max at which it stops falling")
    guide_weight: float = parameter(
        1.0, Number(0, 10000), "weight of the guide against seams, if there is one"
    )

    def __post_init__(self) -> None:
        check_fields(self)

    @classmethod
    def preset(cls, name: str, **changes: Any) -> "TextureParams":
        """Parameters of a preset, some of them changed.

        Raises
        ------
        InputError
            If there is no such preset, or a value is out of range.
        """
        if name not in TEXTURE_PRESETS:
            known = " or ".join(map(repr, TEXTURE_PRESETS))
            raise InputError(f"is {name!r}; it must be {known}", parameter="preset")
        return cls(**{**TEXTURE_PRESETS[name], **changes})

    def radius_at(self, iteration: int) -> int:
        """R of an iteration, from 0 ("Automatic radius R", section 8)."""
        return max(self.radius - iteration * self.radius_step, min(self.radius, self.radius_end))

    def deformation_at(self, iteration: int) -> int:
        """D_max of an iteration, from 0 ("Automatic D_max", section 8)."""
        fallen = self.max_deformation - iteration * self.deformation_step
        return max(fallen, min(self.max_deformation, self.deformation_end))


TEXTURE_PRESETS: dict[str, dict[str, Any]] = {
    "default": {},
    "paper": {
        "radius": 64, "radius_step": 0, "max_deformation": 32, "max_jump": 4, "predicate": "after",
        "weighting": "printed", "second_pass": False, "candidates": 1, "spread": 0,
        "iterations": 16,
    },
    "complete": {
        "radius": 48, "radius_step": 2, "radius_end": 10, "candidates": 1024, "spread": 0,
        "tries": 4, "iterations": 60,
    },
}  # fmt: skip
"""Changes to the defaults; ``paper`` has the settings of section 8, ``complete`` is for holes."""


def as_texture_params(params: TextureParams | None) -> TextureParams:
    """The parameters, or the defaults for None.

    Raises
    ------
    InputError
        If they are anything else, such as the name of a preset or a dict.
    """
    if params is None:
        return TextureParams()
    if isinstance(params, TextureParams):
        return params
    what, remedy = f"of type {type(params).__name__}", "it must be a TextureParams"
    if isinstance(params, str):
        what, remedy = repr(params), f"write TextureParams.preset({params!r})"
    elif isinstance(params, dict):
        what, remedy = "a dict", "write TextureParams(**params)"
    raise InputError(f"is {what}; {remedy}", parameter="params")
