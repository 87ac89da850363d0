"""The methods of stylization and their differences."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from stylit_ref.stylization import schedules, stylit
from stylit_ref.stylization.progress import SearchStep


@dataclass(frozen=True)
class Method:
    """A method of stylization.

    Attributes
    ----------
    name : str
    text : str
        A few words on the method, for help texts.
    search : callable
        ``(level, params, iterate, seed, level_number, vote)``: improves the NNF between two votes,
        a generator of :class:`stylit_ref.stylization.progress.SearchStep`.
    heeds : tuple of str
        The fields of :class:`stylit_ref.Params` that this method uses and some others do not.
    has_guide_map : bool
        Whether a level has a guide map (5.2).
    chooses_targets : bool
        Whether source patches choose among target patches, so that an error counts which only the
        target patch decides.
    schedules : tuple of str
        The schedules that it can run with (:mod:`stylit_ref.stylization.schedules`).
    gpu_schedules, gpu_backends : tuple of str
        The schedules that run as CUDA kernels, and the backends that run them.
    """

    name: str
    text: str
    search: Callable[..., Iterator[SearchStep]]
    heeds: tuple[str, ...]
    has_guide_map: bool = False
    chooses_targets: bool = False
    schedules: tuple[str, ...] = ("propose_commit",)
    gpu_schedules: tuple[str, ...] = ("propose_commit",)
    gpu_backends: tuple[str, ...] = ("cuda", "cuda:shared_memory")

    @property
    def has_penalization(self) -> bool:
        """Whether φ has the term λρ."""
        return "uniformity" in self.heeds


METHODS = {
    method.name: method
    for method in (
        Method(
            "ref",
            "uses all of the painting evenly, as in the thesis",
            schedules.search,
            heeds=("uniformity",),
            schedules=("propose_commit", "scanline"),
            gpu_backends=("cuda", "cuda:shared_memory", "cuda:live", "cuda:live_sums"),
        ),
        Method(
            "guide_map",
            "the same, approximated where guides hardly vary",
            schedules.search,
            heeds=("uniformity", "epsilon"),
            has_guide_map=True,
        ),
        Method(
            "stylit",
            "keeps more of the painting's detail, in five times the time",
            stylit.search,
            heeds=("budget", "fixed_share", "error_limit"),
            chooses_targets=True,
            gpu_backends=(),
        ),
    )
}
"""Every method, by name."""


def heeded_by(name: str) -> list[str] | None:
    """Names of the methods that use a parameter, or None if all of them do."""
    methods = [method.name for method in METHODS.values() if name in method.heeds]
    return methods or None
