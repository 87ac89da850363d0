"""How much of the paper is repeated."""

from dataclasses import dataclass

from eval.documents.lasram.printed import COMPLETED, SIZES


@dataclass(frozen=True)
class Preset:
    """How much is done.

    Attributes
    ----------
    seeds : tuple of int
        Of the study of quality.
    sizes : tuple of int
        Of the table of times.
    trials : int
        Cuts whose quality is measured.
    completed : tuple of int
        Height and width of figure 12.
    memory_of : tuple of int
        Sides of exemplars from which 8192x8192 pixels are made, to see how much memory that takes.
    """

    seeds: tuple[int, ...]
    sizes: tuple[int, ...]
    trials: int
    completed: tuple[int, int]
    memory_of: tuple[int, ...] = ()


PRESETS = {
    "quick": Preset((0,), SIZES[:3], 300, (384, 512)),
    "full": Preset((0, 1, 2, 3, 4), SIZES, 3000, COMPLETED, (1024, 4096)),
}
