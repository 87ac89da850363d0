"""What coherence must reach here, and at which setting it is judged."""

from typing import NamedTuple

from stylit_ref.views.params import PARALLEL, SEQUENTIAL, Coherence

LEAST_GRADIENT = 0.93
LEAST_OUTLINES = 0.9
MOST_GUIDES = 1.02
"""Of what independent frames have."""


class Goal(NamedTuple):
    """Bounds of a study, over independent frames.

    Attributes
    ----------
    coherence : Coherence
        The setting that is judged.
    calmer : float
        How many times smaller the warping error must be.
    cost : float, optional
        Processor time, at most.
    """

    coherence: Coherence
    calmer: float
    cost: float | None = None


GOALS = {
    "house": (Goal(Coherence(1.0), 2.5, 1.15),),
    "large": (Goal(Coherence(1.0), 2.6, 1.35),),
    "animation": (
        Goal(Coherence(1.0, order=SEQUENTIAL), 2.5),
        Goal(Coherence(1.0, order=PARALLEL), 2.0),
    ),
    "sintel": (),
}
"""By the study."""
