"""Progress of a run while it improves the NNF between two votes (the M-step of thesis 2.3)."""

from dataclasses import dataclass
from typing import NamedTuple


class SearchStep(NamedTuple):
    """Progress of a search.

    Attributes
    ----------
    patchmatch_iteration : int
        Iterations since the vote.
    moves : int or None
        Number of assignments that changed; None if they are not counted.
    done : float
        Share of the search that is done, up to 1.
    retrieval : int or None
        Source-to-target retrievals since the vote (``stylit``).
    fixed : float or None
        Share of the target's patches that the retrievals have fixed.
    """

    patchmatch_iteration: int
    moves: int | None
    done: float
    retrieval: int | None = None
    fixed: float | None = None


@dataclass(frozen=True)
class Step:
    """Progress of a run after a step of a search: a PatchMatch iteration, or a retrieval.

    Attributes
    ----------
    level, levels : int
        Pyramid level, 1 the coarsest, and their number.
    height, width : int
        Target size of the level.
    vote : int
        Counted from 1.
    delta, penalization : float
        Mean δ and mean λρ over the target patches; φ is their sum.
    done : float
        Share of the run's work that is done, up to 1.
    patchmatch_iteration : int
        Counted from 1 after each vote.
    moves : int or None
        Number of assignments that changed; None if they are not counted.
    retrieval : int or None
        ``stylit``: source-to-target retrievals since the vote. The last step of a vote has their
        total.
    fixed : float or None
        ``stylit``: share of the target patches that they have fixed since the vote.
    """

    level: int
    levels: int
    height: int
    width: int
    vote: int
    delta: float
    penalization: float
    done: float
    patchmatch_iteration: int
    moves: int | None
    retrieval: int | None
    fixed: float | None
