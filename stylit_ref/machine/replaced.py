"""Replace some passes of a module."""

from collections.abc import Callable
from types import ModuleType, SimpleNamespace
from typing import Any

Passes = ModuleType | SimpleNamespace
"""A module with the functions of :mod:`stylit_ref.passes`, or such a module with some replaced."""


def replaced(passes: Passes, **own: Callable[..., Any]) -> SimpleNamespace:
    """Replace some passes of a module.

    Parameters
    ----------
    passes : module
        :mod:`stylit_ref.passes`, or another that lists its passes in ``__all__``.
    **own : callable
        The replacements, by the names of the passes.

    Returns
    -------
    types.SimpleNamespace
        All passes of the module, with ``__all__``.
    """
    names = {name: getattr(passes, name) for name in passes.__all__}
    return SimpleNamespace(**names | own, __all__=[*names, *sorted(own.keys() - names)])
