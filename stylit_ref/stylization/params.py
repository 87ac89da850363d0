"""Parameters of a stylization; the defaults are those of thesis 4.1."""

from dataclasses import dataclass
from numbers import Integral, Real
from typing import Literal, get_args

import numpy as np

from stylit_ref.errors import InputError

Method = Literal["ref", "shared_memory", "guide_map", "stylit"]
Schedule = Literal["propose_commit", "scanline", "live", "live_sums"]


@dataclass(frozen=True)
class Params:
    """What shapes the result, apart from the images and the seed.

    Attributes
    ----------
    method : {"ref", "shared_memory", "guide_map", "stylit"}
        Texture optimization with an occurrence map (thesis 2, 3); the same by kernels that keep
        target patches in shared memory (5.1, a GPU's); with guide maps
        (5.2, :mod:`stylit_ref.formulae.guide_map`); StyLit
        (1.5, :mod:`stylit_ref.stylization.stylit`).
    patch_width : int
        w, odd, in pixels (4.1: 5).
    levels : int
        Levels of the pyramid (4.1: 6); fewer are used where the coarsest would be
        smaller than a patch.
    votes : int or tuple of int
        EM iterations a level: a vote, then PatchMatch (4.1: 6). A tuple names them from
        the finest level on; its last holds for all coarser ones.
    patchmatch_iterations : int
        PatchMatch iterations after each vote (4.1: 6).
    uniformity : float
        λ, the weight of the patch penalization ρ (4.3: best in 5000 to 15000).
    guide_influence : float
        μ, the weight of all guides together against the style (4.1: 2).
    guide_weights : tuple of float, optional
        A factor for each guide's share of μ; 1 for every guide by default.
    schedule : {"propose_commit", "scanline", "live", "live_sums"}
        How PatchMatch proceeds and when Ω changes
        (:mod:`stylit_ref.stylization.schedules`); all but the first are for ``ref`` alone.
    vote_outliers : int
        t, the votes farthest from a pixel's mean that do not count (Hauptfleisch 2.4.1:
        3 to 5); 0 for the plain mean.
    epsilon : float
        ``guide_map``: ε, in squared 8-bit steps (5.2.4: about 100). Guides of target patches
        that vary by less are compared by their means; 0 for none.
    budget : "hyperbola" or float
        ``stylit``: how the error budget is found
        (:mod:`stylit_ref.stylization.error_budget`): at the knee of a fitted hyperbola, or as a share of the sum of all errors (Hauptfleisch 4.1.2: 0.9).
    fixed_share : float
        ``stylit``: share of the target's patches that source-to-target retrieval fixes before
        a target-to-source one takes over.
    error_limit : float, optional
        ``stylit``: α. A patch is not fixed with an error above α times that of the best source
        patch found for it (Hauptfleisch 2.4.1: 5).

    Raises
    ------
    InputError
        If a value is out of range.
    """

    method: Method = "ref"
    patch_width: int = 5
    levels: int = 6
    votes: int | tuple[int, ...] = 6
    patchmatch_iterations: int = 6
    uniformity: float = 10000.0
    guide_influence: float = 2.0
    guide_weights: tuple[float, ...] | None = None
    schedule: Schedule = "propose_commit"
    vote_outliers: int = 0
    epsilon: float = 100.0
    budget: Literal["hyperbola"] | float = "hyperbola"
    fixed_share: float = 0.95
    error_limit: float | None = None

    def __post_init__(self):
        if not _is_one_of(self.method, METHODS):
            raise InputError(
                f"method is {self.method!r}; it must be 'ref', 'shared_memory', 'guide_map' or "
                "'stylit'"
            )
        width = self.patch_width
        if not isinstance(width, Integral) or width % 2 == 0 or not 3 <= width <= 63:
            raise InputError(f"patch_width is {width}; it must be an odd integer from 3 to 63")
        _check_count("levels", self.levels, 16)
        _check_count("patchmatch_iterations", self.patchmatch_iterations, 65535)
        if _is_sequence(self.votes) and len(self.votes):
            object.__setattr__(self, "votes", tuple(self.votes))
            for votes in self.votes:
                _check_count("votes", votes, 65535)
        else:
            _check_count("votes", self.votes, 65535)
        for name in ("uniformity", "guide_influence"):
            _check_weight(name, getattr(self, name))
        if self.guide_weights is not None:
            if not _is_sequence(self.guide_weights):
                raise InputError(f"guide_weights is {self.guide_weights}; it must be a sequence")
            object.__setattr__(self, "guide_weights", tuple(self.guide_weights))
            for k, weight in enumerate(self.guide_weights, 1):
                _check_weight(f"guide weight {k}", weight)
        if not _is_one_of(self.schedule, SCHEDULES):
            raise InputError(
                f"schedule is {self.schedule!r}; it must be 'propose_commit', 'scanline', 'live' "
                "or 'live_sums'"
            )
        if self.schedule != "propose_commit" and self.method != "ref":
            raise InputError(
                f"schedule is {self.schedule!r}; it is for method 'ref' alone, and the method is "
                f"{self.method!r}"
            )
        most = width**2 - 1
        if not isinstance(self.vote_outliers, Integral) or not 0 <= self.vote_outliers <= most:
            raise InputError(
                f"vote_outliers is {self.vote_outliers}; it must be an integer from 0 to {most}, "
                f"for patches of width {width}"
            )
        _check_weight("epsilon", self.epsilon)
        if not _is_one_of(self.budget, ("hyperbola",)):
            _check_share("budget", self.budget, "'hyperbola' or a share ")
        _check_share("fixed_share", self.fixed_share, "a share ")
        if self.error_limit is not None and not (
            isinstance(self.error_limit, Real) and 1 <= self.error_limit <= LARGEST_WEIGHT
        ):
            raise InputError(
                f"error_limit is {self.error_limit}; it must be a number from 1 to "
                f"{LARGEST_WEIGHT:g}"
            )

        self._simplify()

    def _simplify(self):
        """Python's own numbers in the place of NumPy's and fractions: one value, one repr."""
        plain = {name: int(getattr(self, name)) for name in _COUNTS}
        plain |= {name: float(getattr(self, name)) for name in _NUMBERS}
        several = isinstance(self.votes, tuple)
        plain["votes"] = tuple(map(int, self.votes)) if several else int(self.votes)
        if self.guide_weights is not None:
            plain["guide_weights"] = tuple(map(float, self.guide_weights))
        if self.budget != "hyperbola":
            plain["budget"] = float(self.budget)
        if self.error_limit is not None:
            plain["error_limit"] = float(self.error_limit)
        for name, value in plain.items():
            object.__setattr__(self, name, value)

    def votes_above(self, depth):
        """Votes of the level ``depth`` levels above the finest, coarser ones lying above."""
        if isinstance(self.votes, tuple):
            return self.votes[min(depth, len(self.votes) - 1)]
        return self.votes


PRESETS = {
    "thesis": {},
    "fast": {"levels": 7, "votes": (1, 4, 6), "patchmatch_iterations": 1},
}
"""Named effort: values of :class:`Params` for the work spent, from the thesis' to a preview's.

Votes at coarse levels cost little and settle most of what the finest shows, so ``fast`` spends
them there.
"""

METHODS, SCHEDULES = get_args(Method), get_args(Schedule)
HEEDED_BY = {
    "uniformity": ("ref", "shared_memory", "guide_map"),
    "epsilon": ("guide_map",),
    "budget": ("stylit",),
    "fixed_share": ("stylit",),
    "error_limit": ("stylit",),
}
"""The methods that heed a parameter, where not all of them do."""

LARGEST_WEIGHT = 1e12

_COUNTS = "patch_width", "levels", "patchmatch_iterations", "vote_outliers"
_NUMBERS = "uniformity", "guide_influence", "epsilon", "fixed_share"


def _is_one_of(value, names):
    return isinstance(value, str) and value in names


def _is_sequence(value):
    try:
        return np.ndim(value) == 1
    except ValueError:  # rows of different lengths
        return False


def _check_count(name, value, most):
    if not isinstance(value, Integral) or not 1 <= value <= most:
        raise InputError(f"{name} is {value}; it must be an integer from 1 to {most}")


def _check_weight(name, value):
    if not isinstance(value, Real) or not 0 <= value <= LARGEST_WEIGHT:
        raise InputError(f"{name} is {value}; it must be a number from 0 to {LARGEST_WEIGHT:g}")


def _check_share(name, value, what):
    if not isinstance(value, Real) or not 0 < value <= 1:
        raise InputError(f"{name} is {value!r}; it must be {what}above 0 and up to 1")
