"""What a search tells while it improves the NNF between two votes (the M-step of thesis 2.3)."""

from typing import NamedTuple


class SearchStep(NamedTuple):
    """Where a search stands.

    Attributes
    ----------
    patchmatch_iteration : int
        Iterations since the vote.
    moves : int or None
        Assignments that changed, where they are counted.
    done : float
        Share of the search, up to 1.
    retrieval : int or None
        Source-to-target retrievals since the vote (``stylit``).
    fixed : float or None
        Share of the target's patches they have fixed.
    """

    patchmatch_iteration: int
    moves: int | None
    done: float
    retrieval: int | None = None
    fixed: float | None = None
