"""Parameters of coherence."""

from dataclasses import dataclass

from stylit_ref.parameters import Choice, Number, check_fields, parameter

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

    def __post_init__(self) -> None:
        check_fields(self)


SEQUENCE = Coherence(weight=1, order=SEQUENTIAL)
"""What suits a sequence; the defaults suit a grid."""
