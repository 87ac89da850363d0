"""The methods that ``run`` offers."""

from collections.abc import Callable
from typing import NamedTuple

from stylit_ref.errors import InputError
from stylit_ref.stylization.methods import METHODS
from stylit_ref.stylization.params import Params
from stylit_ref.stylization.stylize import stylize


class Offer(NamedTuple):
    """What there is to a method, seen from the command line.

    Attributes
    ----------
    params : type
        Dataclass of its parameters.
    run : callable
        Called as :func:`stylit_ref.stylize`.
    """

    params: type
    run: Callable


OFFERS = dict.fromkeys(METHODS, Offer(Params, stylize))
"""By the name that ``--method`` takes."""


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
