"""The methods that ``run`` offers."""

from collections.abc import Callable
from dataclasses import fields
from typing import Any, NamedTuple

from stylit_ref.machine.compilation import Specialization
from stylit_ref.parameters import Choice
from stylit_ref.realtime.params import REALTIME_PRESETS, RealtimeParams
from stylit_ref.stylization.methods import METHODS, heeded_by
from stylit_ref.stylization.params import PRESETS, Params
from stylit_ref.stylization.stylize import stylize
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
    options : tuple of str
        Options of ``run`` beside the parameters that this method heeds and others do not.
    run : callable
        Called as :func:`stylit_ref.stylize`; of ``realtime``, which takes its guides by name, as
        :func:`stylit_ref.cli.realtime.realtime_frame`.
    kernels : callable
        Called as :func:`stylit_ref.stylization.warm_up.kernels_of_run`.
    """

    text: str
    params: type
    heeds: tuple[str, ...]
    presets: dict[str, dict[str, Any]]
    options: tuple[str, ...]
    run: Callable[..., Any]
    kernels: Callable[..., list[Specialization]]


def _stylization(method):
    names = [each.name for each in fields(Params)]
    heeds = [name for name in names if method.name in (heeded_by(name) or METHODS)]
    options = "mask", "fill", "save_levels", "backend", "verbose"
    presets = {
        name: values
        for name, values in PRESETS.items()
        if values.get("method", method.name) == method.name
    }
    return Offer(method.text, Params, tuple(heeds), presets, options, stylize, kernels_of_run)


def _realtime_frame(*inputs, **settings):
    from stylit_ref.cli.realtime import realtime_frame  # imported late: other methods need none

    return realtime_frame(*inputs, **settings)


def _kernels_of_realtime(*channels):
    from stylit_ref.cli.realtime import kernels_of_realtime

    return kernels_of_realtime(*channels)


OFFERS = {name: _stylization(method) for name, method in METHODS.items()} | {
    "realtime": Offer(
        "a frame in milliseconds, for programs that show a picture while it is painted",
        RealtimeParams,
        tuple(each.name for each in fields(RealtimeParams)),
        REALTIME_PRESETS,
        ("warm_start",),
        _realtime_frame,
        _kernels_of_realtime,
    )
}
"""By the name that ``--method`` takes; the first is the default."""


def made_params(method: str, values: dict[str, Any]) -> Any:
    """Parameters of a method from values by name; those of other methods are left out."""
    offer = OFFERS[method]
    names = {each.name for each in fields(offer.params)}
    values = values | {"method": method}
    return offer.params(**{name: value for name, value in values.items() if name in names})


def offer_of(method: str) -> Offer:
    """The row of a method.

    Raises
    ------
    InputError
        If none has that name.
    """
    return OFFERS[Choice(tuple(OFFERS)).check("method", method)]
