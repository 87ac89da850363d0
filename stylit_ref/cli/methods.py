"""The methods that ``run`` offers."""

from collections.abc import Callable
from dataclasses import fields
from typing import Any, NamedTuple

from stylit_ref.errors import InputError
from stylit_ref.machine.kernel import Specialization
from stylit_ref.stylization.methods import METHODS, heeded_by
from stylit_ref.stylization.params import PRESETS, Params
from stylit_ref.stylization.stylize import Result, stylize
from stylit_ref.stylization.warm_up import kernels_of_run


class Offer(NamedTuple):
    """What there is to a method, seen from the command line.

    Attributes
    ----------
    text : str
        What it is, in a few words.
    params : type
        Dataclass of its parameters, made by :func:`stylit_ref.parameters.parameter`.
    heeds : tuple of str
        Those of them that this method heeds.
    presets : dict of str to dict
        Values of them by the name that ``--preset`` takes.
    run : callable
        Called as :func:`stylit_ref.stylize`.
    kernels : callable
        Called as :func:`stylit_ref.stylization.warm_up.kernels_of_run`.
    """

    text: str
    params: type
    heeds: tuple[str, ...]
    presets: dict[str, dict[str, Any]]
    run: Callable[..., Result]
    kernels: Callable[..., list[Specialization]]


def _stylization(method):
    names = [each.name for each in fields(Params)]
    heeds = [name for name in names if method.name in (heeded_by(name) or METHODS)]
    return Offer(method.text, Params, tuple(heeds), PRESETS, stylize, kernels_of_run)


OFFERS = {name: _stylization(method) for name, method in METHODS.items()}
"""By the name that ``--method`` takes; the first is the default."""


def offer_of(method: str) -> Offer:
    """The row of a method.

    Raises
    ------
    InputError
        If none has that name.
    """
    if method not in OFFERS:
        *others, last = map(repr, OFFERS)
        raise InputError(
            f"is {method!r}; it must be {', '.join(others)} or {last}", parameter="method"
        )
    return OFFERS[method]
