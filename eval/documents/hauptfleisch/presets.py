"""How much of the thesis is repeated."""

from dataclasses import dataclass

from stylit_ref.stylization.params import Params
from stylit_ref.views.params import PLAIN, SEQUENTIAL, SWEEPS, Coherence


@dataclass(frozen=True)
class Preset:
    """How much is done.

    Attributes
    ----------
    methods : dict of str to Params
    ways : dict of str to (dict of str to tuple of Coherence)
        How frames pull at each other, by study and method.
    frames : int
        Of the animation.
    rounds : int
        How often each run takes its turn where times are compared.
    costed : tuple of (str, str)
        Studies and methods whose times are compared.
    styles : tuple of str
        Other sketches over the house, with ref at the setting that is judged.
    sketches : tuple of str
        Those whose parts of ``--preset architecture`` are switched off.
    with_large_times : bool
        Whether 100 frames of 960x544 are stylized, and a sketch of the thesis' size.
    """

    methods: dict[str, Params]
    ways: dict[str, dict[str, tuple[Coherence, ...]]]
    frames: int
    rounds: int
    costed: tuple[tuple[str, str], ...]
    styles: tuple[str, ...]
    sketches: tuple[str, ...]
    with_large_times: bool = False


_WEIGHTS = tuple(Coherence(weight) for weight in (0.25, 0.5, 1.0, 2.0))

_GRID = (
    *_WEIGHTS,
    Coherence(0.5, PLAIN),
    Coherence(1.0, order=SWEEPS),
    Coherence(1.0, order=SEQUENTIAL),
)

_ANIMATION = (
    *(Coherence(weight, order=SEQUENTIAL) for weight in (0.5, 1.0, 2.0)),
    Coherence(1.0),
    Coherence(1.0, order=SWEEPS),
)

_AFTER = Coherence(1.0, order=SEQUENTIAL)

_EFFORT = {"votes": (3, 4), "patchmatch_iterations": 2}
"""A third of the work."""

PRESETS = {
    "quick": Preset(
        methods={"ref": Params(**_EFFORT), "stylit": Params("stylit", error_limit=5, **_EFFORT)},
        ways={
            "house": {"ref": _GRID, "stylit": (Coherence(1.0),)},
            "large": {"ref": (Coherence(1.0),)},
            "animation": {"ref": _ANIMATION},
            "sintel": {"ref": (_AFTER,)},
        },
        frames=11,
        rounds=1,
        costed=(("house", "ref"),),
        styles=("washed", "hatched", "marker"),
        sketches=("inked",),
    ),
    "full": Preset(
        methods={"ref": Params(), "stylit": Params("stylit", error_limit=5)},
        ways={
            "house": {"ref": (*_GRID, Coherence(1.0, PLAIN)), "stylit": _GRID},
            "large": {"ref": _WEIGHTS, "stylit": (Coherence(0.5), Coherence(1.0))},
            "animation": {"ref": _ANIMATION, "stylit": _ANIMATION},
            "sintel": {"ref": (_AFTER,), "stylit": (_AFTER,)},
        },
        frames=16,
        rounds=3,
        costed=tuple(
            (study, method) for study in ("house", "large") for method in ("ref", "stylit")
        ),
        styles=("washed", "hatched", "marker", "two_walls", "unshadowed"),
        sketches=("inked", "hatched", "marker"),
        with_large_times=True,
    ),
}
