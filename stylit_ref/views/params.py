"""Parameters of coherence."""

from dataclasses import dataclass, replace

from stylit_ref.errors import InputError
from stylit_ref.parameters import (
    Choice,
    Integer,
    Number,
    OneOrSeveral,
    Optional,
    check_fields,
    parameter,
)

LARGEST_WEIGHT = 64

NORM, PLAIN = "norm", "plain"
PARALLEL, SWEEPS, SEQUENTIAL = "parallel", "sweeps", "sequential"


@dataclass(frozen=True)
class Coherence:
    """How much neighbouring frames pull at each other, and in which order they are stylized.

    Attributes
    ----------
    weight : float
        λ_c, of one neighbour, against 1 for the frame's own style term (3.1); it counts in steps of
        1/256. 0.5 suits grids, 1 sequences. 0 stylizes every frame by itself.
    form : {"norm", "plain"}
        ``norm`` divides the style term by 1 + Σ λ_c, so that guides count as much as without
        coherence; ``plain`` is equation 3.1 as printed.
    order : {"parallel", "sweeps", "sequential"}
        ``parallel``: one search-vote iteration of every frame, then the next (3.2.2). ``sweeps``:
        each frame sees what its neighbours have become in the same iteration; frames are taken in
        order and back again in turns. ``sequential``: a frame is finished before the next begins,
        and sees finished neighbours only.
    following_votes : int or tuple of int, optional
        In ``sequential`` order the search-vote iterations of frames at which others pull, as
        ``votes`` of :class:`~stylit_ref.Params` tells those of the rest; None for as many. The
        finished picture pulls from the coarsest level on, so that fewer suffice.
    """

    weight: float = parameter(
        0.5, Number(0, LARGEST_WEIGHT), "how much each neighbouring frame counts; 0 for not at all"
    )
    form: str = parameter(
        NORM,
        Choice((NORM, PLAIN)),
        "norm keeps what the guides count; plain adds the coherence to the style",
    )
    order: str = parameter(
        PARALLEL,
        Choice((PARALLEL, SWEEPS, SEQUENTIAL)),
        "parallel, all frames at once; sweeps, forth and back; or sequential, one after the other",
    )
    following_votes: int | tuple[int, ...] | None = parameter(
        None,
        Optional(OneOrSeveral(Integer(1, 65535))),
        "search-vote iterations of a frame that follows another in a sequential order, told as "
        "those of --search-vote-iters. Without it as many as those; 'stylit-ref sequence --preset "
        "fast' takes 1,2,4, unless --search-vote-iters is given",
    )

    def __post_init__(self) -> None:
        check_fields(self)
        if self.following_votes is None:
            return
        if self.order != SEQUENTIAL:
            raise InputError(
                f"is of use with order {SEQUENTIAL!r} alone, and the order is {self.order!r}; "
                "leave it out",
                parameter="following_votes",
            )
        if not self.weight:
            raise InputError(
                "is of use with a coherence above 0 alone, since no frame follows another without "
                "it; leave it out",
                parameter="following_votes",
            )


SEQUENCE = Coherence(weight=1, order=SEQUENTIAL)
"""What suits a sequence; the defaults suit a grid."""

FAST_SEQUENCE = replace(SEQUENCE, following_votes=(1, 2, 4))
"""What suits one with the preset ``fast``."""
