"""What a stage is to the library."""

from collections.abc import Callable
from typing import NamedTuple


class Stage(NamedTuple):
    """How the library does a stage.

    Attributes
    ----------
    do : callable
        ``(passes, parameters, arrays) -> dict of str to array``.
    passes : tuple of str
        Names of the passes that it uses. Without any it is done by formulae of the library alone,
        and checks no other module.
    """

    do: Callable
    passes: tuple[str, ...] = ()


LEVEL = "upload", "zeros", "repeat_edge", "moments_storage", "patch_moments"
"""Passes that lay out a level."""

SEARCH = *LEVEL, "propagation", "random_search", "commit"
