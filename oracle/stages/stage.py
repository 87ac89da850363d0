"""How the library runs a stage."""

from collections.abc import Callable
from typing import NamedTuple


class Stage(NamedTuple):
    """How the library runs a stage.

    Attributes
    ----------
    do : callable
        ``(passes, parameters, arrays) -> dict of str to array``.
    passes : tuple of str
        Names of the passes that it uses. A stage without any uses formulae of the library alone,
        so it cannot check another module.
    """

    do: Callable
    passes: tuple[str, ...] = ()


LEVEL = "upload", "zeros", "repeat_edge", "moments_storage", "patch_moments"
"""Passes that prepare a level."""

SEARCH = *LEVEL, "propagation", "random_search", "commit"
