"""Parameters of a stylization; the defaults are those of thesis 4.1."""

from dataclasses import dataclass
from typing import Any, Literal

from stylit_ref.errors import InputError
from stylit_ref.parameters import (
    Choice,
    Integer,
    Number,
    OneOrSeveral,
    Optional,
    OrWord,
    Several,
    Share,
    check_fields,
    parameter,
)
from stylit_ref.stylization.methods import METHODS, Method
from stylit_ref.stylization.schedules import SCHEDULES

LARGEST_WEIGHT = 1e12
_WEIGHT = Number(0, LARGEST_WEIGHT)

ALL = "all"
"""Value of ``levels`` for as many as fit."""

MOST_LEVELS = 16


@dataclass(frozen=True)
class Params:
    """What shapes the result, apart from the images and the seed.

    Attributes
    ----------
    method : {"ref", "guide_map", "stylit"}
        Texture optimization with an occurrence map (thesis 2, 3); with guide maps
        (5.2, :mod:`stylit_ref.formulae.guide_map`); StyLit
        (1.5, :mod:`stylit_ref.stylization.stylit`).
    patch_width : int
        w, odd, in pixels (4.1: 5). ``--patch-size`` on the command line.
    levels : int or "all"
        Levels of the pyramid (4.1: 6); fewer are used where the coarsest would be
        smaller than a patch, and ``all`` is as many as that allows: 6 for an image of 300x228, 8
        for 1200x912. ``--pyramid-levels`` on the command line.
    votes : int or tuple of int
        EM iterations a level: a vote, then PatchMatch (4.1: 6). A tuple names them from
        the finest level on; its last holds for all coarser ones. ``--search-vote-iters`` on
        the command line.
    patchmatch_iterations : int
        PatchMatch iterations after each vote (4.1: 6). ``--patchmatch-iters`` on the command
        line.
    uniformity : float
        λ, the weight of the patch penalization ρ (4.3: best in 5000 to 15000).
    guide_influence : float
        μ, the weight of all guides together against the style (4.1: 2).
    guide_weights : tuple of float, optional
        A factor for each guide's share of μ; 1 for every guide by default.
    schedule : {"propose_commit", "scanline"}
        How PatchMatch proceeds and when Ω changes
        (:mod:`stylit_ref.stylization.schedules`); the second is for ``ref`` alone.
    vote_outliers : int
        t, the votes farthest from a pixel's mean that do not count (Hauptfleisch 2.4.1:
        3 to 5); 0 for the plain mean.
    epsilon : float
        ``guide_map``: ε, in squared 8-bit steps (5.2.4: about 100). Guides of target patches
        that vary by less are compared by their means; 0 for none.
    budget : "hyperbola" or float
        ``stylit``: how the error budget is found
        (:mod:`stylit_ref.stylization.error_budget`): at the knee of a fitted hyperbola, or as a
        share of the sum of all errors (Hauptfleisch 4.1.2: 0.9).
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

    method: str = parameter(
        "ref",
        Choice(tuple(METHODS)),
        "; ".join(f"{method.name}, {method.text}" for method in METHODS.values()),
    )
    patch_width: int = parameter(5, Integer(3, 63, odd=True), "width of the patches in pixels, odd")
    levels: int | Literal["all"] = parameter(
        6,
        OrWord(ALL, Integer(1, MOST_LEVELS)),
        "levels of the image pyramid; all takes as many as fit, so that the coarsest shows the "
        "picture as a whole",
    )
    votes: int | tuple[int, ...] = parameter(
        6,
        OneOrSeveral(Integer(1, 65535)),
        "search-vote iterations at every level; 1,4,6 means 1 at the finest, 4 at the next, 6 at "
        "all others",
    )
    patchmatch_iterations: int = parameter(
        6, Integer(1, 65535), "PatchMatch iterations after every vote"
    )
    uniformity: float = parameter(
        10000.0, _WEIGHT, "λ, how evenly the painting is used: 5000 to 15000 suits most"
    )
    guide_influence: float = parameter(
        2.0, _WEIGHT, "μ, weight of all guides together against 1 for the painting"
    )
    guide_weights: tuple[float, ...] | None = parameter(
        None, Optional(Several(_WEIGHT, "guide weight")), "factors of the guides"
    )
    schedule: str = parameter(
        "propose_commit",
        Choice(tuple(SCHEDULES)),
        "propose_commit, on all threads, or scanline, on one, as in the thesis' chapter 2",
    )
    vote_outliers: int = parameter(
        0,
        Integer(0, 63**2 - 1),
        "votes farthest from their mean that do not count; 4 makes lines crisper",
    )
    epsilon: float = parameter(
        100.0,
        _WEIGHT,
        "with --method guide_map: ε, the variance of guides below which their means are compared",
    )
    budget: Literal["hyperbola"] | float = parameter(
        "hyperbola",
        OrWord("hyperbola", Share()),
        "with --method stylit: how much error is accepted; hyperbola finds it, or a share of all "
        "errors, as 0.9",
    )
    fixed_share: float = parameter(
        0.95,
        Share(),
        "with --method stylit: share of the target that source patches fill; the rest is searched "
        "the other way round",
    )
    error_limit: float | None = parameter(
        None,
        Optional(Number(1, LARGEST_WEIGHT)),
        "with --method stylit: α, the largest error that a patch accepts, over the least it found",
    )

    def __post_init__(self) -> None:
        check_fields(self)
        width = self.patch_width  # one vote is always kept
        votes = Integer(0, width**2 - 1, remark=f", for patches of width {width}")
        votes.check("vote_outliers", self.vote_outliers)
        if self.schedule not in self.traits.schedules:
            methods = [repr(name) for name in METHODS if self.schedule in METHODS[name].schedules]
            raise InputError(
                f"is {self.schedule!r}; it is for method {' or '.join(methods)} alone, and the "
                f"method is {self.method!r}",
                parameter="schedule",
            )

    @classmethod
    def preset(cls, name: str) -> "Params":
        """Parameters of a named effort; :func:`dataclasses.replace` changes some of them.

        Parameters
        ----------
        name : {"final", "fast", "thesis", "architecture"}
            One of :data:`PRESETS`.

        Raises
        ------
        InputError
            If none has that name.
        """
        return cls(**PRESETS[Choice(tuple(PRESETS)).check("preset", name)])

    @property
    def traits(self) -> Method:
        """What the method is: its row of :data:`stylit_ref.stylization.methods.METHODS`."""
        return METHODS[self.method]

    @property
    def penalization(self) -> float:
        """λ, or 0 of a method without a patch penalization."""
        return self.uniformity if self.traits.has_penalization else 0.0

    def votes_above(self, depth: int) -> int:
        """Votes of the level ``depth`` levels above the finest, coarser ones lying above."""
        if isinstance(self.votes, tuple):
            return self.votes[min(depth, len(self.votes) - 1)]
        return self.votes


PRESETS: dict[str, dict[str, Any]] = {
    "final": {"levels": ALL},
    "fast": {"levels": 7, "votes": (1, 4, 6), "patchmatch_iterations": 1},
    "thesis": {},
    "architecture": {
        "method": "stylit",
        "levels": ALL,
        "budget": 0.9,
        "error_limit": 5.0,
        "vote_outliers": 4,
    },
}
"""Named parameters: values of :class:`Params`, the command line's default first.

``final``, for the finished picture, works as hard as the thesis, but begins at the coarsest level
that holds a patch. There a patch shows where the ground ends and the wall begins, even if both are
lit alike, so that less paint spills (``reports/levels``). ``fast`` is a preview. Votes at coarse
levels cost little and settle most of what the finest shows, so it spends them there.
``architecture``, for a sketch of a building seen from another side, has the choices of Hauptfleisch
2.4.1 and 4.1.2; a wireframe belongs among its guides.
"""


def as_params(params: Params | None) -> Params:
    """The parameters, or those of the thesis for None.

    Raises
    ------
    InputError
        If they are anything else, as the name of a preset or its values.
    """
    if params is None:
        return Params()
    if isinstance(params, Params):
        return params
    if isinstance(params, str):
        Params.preset(params)  # refuses a name that is none
        what, remedy = repr(params), f"write Params.preset({params!r})"
    elif isinstance(params, dict):
        names = [name for name, values in PRESETS.items() if values == params]
        remedy = f"write Params.preset({names[0]!r})" if names else "write Params(**params)"
        what = "a dict"
    else:
        what, remedy = f"of type {type(params).__name__}", "it must be a Params"
    raise InputError(f"is {what}; {remedy}", parameter="params")
