"""Parameters of a stylization; the defaults are those of thesis 4.1."""

from dataclasses import dataclass
from numbers import Integral, Real
from typing import Literal

import numpy as np

from stylit_ref.errors import InputError

Schedule = Literal["propose_commit", "scanline"]


@dataclass(frozen=True)
class Params:
    """What shapes the result, apart from the images and the seed.

    Attributes
    ----------
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
    schedule : {"propose_commit", "scanline"}
        How PatchMatch proceeds and when Ω changes
        (:mod:`stylit_ref.patchmatch`).

    Raises
    ------
    InputError
        If a value is out of range.
    """

    patch_width: int = 5
    levels: int = 6
    votes: int | tuple[int, ...] = 6
    patchmatch_iterations: int = 6
    uniformity: float = 10000.0
    guide_influence: float = 2.0
    guide_weights: tuple[float, ...] | None = None
    schedule: Schedule = "propose_commit"

    def __post_init__(self):
        width = self.patch_width
        if not isinstance(width, Integral) or width % 2 == 0 or not 3 <= width <= 63:
            raise InputError(f"patch_width is {width}; it must be an odd integer from 3 to 63")
        _check_count("levels", self.levels, 16)
        _check_count("patchmatch_iterations", self.patchmatch_iterations, 65535)
        if np.ndim(self.votes) == 1 and len(self.votes):
            object.__setattr__(self, "votes", tuple(self.votes))
            for votes in self.votes:
                _check_count("votes", votes, 65535)
        else:
            _check_count("votes", self.votes, 65535)
        for name in ("uniformity", "guide_influence"):
            _check_weight(name, getattr(self, name))
        if self.guide_weights is not None:
            if np.ndim(self.guide_weights) != 1:
                raise InputError(f"guide_weights is {self.guide_weights}; it must be a sequence")
            object.__setattr__(self, "guide_weights", tuple(self.guide_weights))
            for k, weight in enumerate(self.guide_weights, 1):
                _check_weight(f"guide weight {k}", weight)
        if self.schedule not in ("propose_commit", "scanline"):
            raise InputError(
                f"schedule is {self.schedule!r}; it must be 'propose_commit' or 'scanline'"
            )

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

LARGEST_WEIGHT = 1e12


def _check_count(name, value, most):
    if not isinstance(value, Integral) or not 1 <= value <= most:
        raise InputError(f"{name} is {value}; it must be an integer from 1 to {most}")


def _check_weight(name, value):
    if not isinstance(value, Real) or not 0 <= value <= LARGEST_WEIGHT:
        raise InputError(f"{name} is {value}; it must be a number from 0 to {LARGEST_WEIGHT:g}")
