"""Options of ``run`` that shape the result, and the parameters that they give."""

import argparse
from collections.abc import Collection
from dataclasses import Field, fields
from typing import Any

from stylit_ref.cli.guide_options import guide_weights
from stylit_ref.cli.methods import OFFERS, made_params, offer_of
from stylit_ref.cli.parameter_options import add_parameter
from stylit_ref.errors import InputError
from stylit_ref.parameters import SPELLED
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.stylization.params import PRESETS, Params

_DENSE_PRESETS = (
    "final: the finished picture; fast: a preview, close to the eye, a thirteenth of the work; "
    "thesis: as final, with the 6 levels of the thesis; architecture: --method stylit as sketches "
    "of buildings need it (default final)"
)
_REALTIME_PRESETS = (
    "; of --method realtime best: the better picture; quick: six tenths of the time; simple, "
    "optimized: the two methods of Heidrich's thesis (default best)"
)

_OTHERS = "method", "guide_weights"
"""Parameters whose options are made by hand: ``--weight`` stands beside its guide."""


def add_method(group: argparse._ArgumentGroup, methods: Collection[str] = tuple(OFFERS)) -> None:
    """Add ``--method`` with a choice of these; the first is the default."""
    texts = "; ".join(f"{name}: {OFFERS[name].text}" for name in methods)
    group.add_argument(
        "--method", metavar="NAME",
        help=f"{texts} (default {next(iter(methods))}, or that of the preset)",
    )  # fmt: skip


def add_preset(group: argparse._ArgumentGroup, methods: Collection[str] = tuple(OFFERS)) -> None:
    """Add ``--preset`` with those of these methods."""
    presets = dict.fromkeys(name for method in methods for name in OFFERS[method].presets)
    of_realtime = _REALTIME_PRESETS if "realtime" in methods else ""
    group.add_argument("--preset", choices=presets, help=f"{_DENSE_PRESETS}{of_realtime}")


def add_parameters(
    group: argparse._ArgumentGroup,
    names: Collection[str] | None = None,
    without: Collection[str] = (),
) -> None:
    """Add an option for each parameter, None where it is not given.

    Parameters
    ----------
    group : argparse._ArgumentGroup
    names : collection of str, optional
        Parameters to add; all by default.
    without : collection of str
        Those to leave out.
    """
    for each in parameters_of(*OFFERS):
        if each.name in without or (names is not None and each.name not in names):
            continue
        add_parameter(group, each, _default(each), SPELLED.get(each.name))


def _default(field):
    """What a run takes that names neither the option nor a preset."""
    preset = next(iter(offer_of(next(iter(OFFERS))).presets.values()))
    return preset.get(field.name, field.default)


def parameters_of(*methods: str) -> "list[Field[Any]]":
    """Fields of the methods' parameter classes that have an option here, each name once."""
    classes = dict.fromkeys(offer_of(method).params for method in methods)
    named = {}
    for each in (each for params in classes for each in fields(params)):
        named.setdefault(each.name, each)
    return [each for name, each in named.items() if name not in _OTHERS]


def method_of(options: argparse.Namespace) -> str:
    """The method that was named, or that of the preset, or the default."""
    values = PRESETS.get(getattr(options, "preset", None) or "", {})
    return options.method or values.get("method", next(iter(OFFERS)))


def chosen_params(options: argparse.Namespace) -> Params | RealtimeParams:
    """Parameters of the method that was chosen.

    Parameters
    ----------
    options : argparse.Namespace
        Of the functions above, ``--preset`` among them; and of the images, if the command has any.

    Returns
    -------
    Params or RealtimeParams

    Raises
    ------
    InputError
        If a value is out of range, or for another method.
    """
    method = method_of(options)
    offer = offer_of(method)
    _refuse_others(options, method)
    given = {each.name: getattr(options, each.name, None) for each in parameters_of(*OFFERS)}
    chosen = {name: value for name, value in given.items() if value is not None}
    for name in chosen:
        if name not in offer.heeds:
            methods = [method for method, other in OFFERS.items() if name in other.heeds]
            raise InputError(
                f"is for --method {', '.join(methods)}; the method is {method}",
                parameter=name,
            )
    values = chosen
    if "preset" in options:
        preset = options.preset or next(iter(offer.presets))
        if preset not in offer.presets:
            raise InputError(
                f"is {preset}, which is not for --method {method}; that has "
                f"{', '.join(offer.presets)}",
                parameter="preset",
            )
        values = offer.presets[preset] | values
    if "guide" in options:
        values["guide_weights"] = guide_weights(options)
    return made_params(method, values)


def _refuse_others(options, method):
    """Refuse what is no parameter, and for other methods alone."""
    own = offer_of(method).options
    for name in dict.fromkeys(name for offer in OFFERS.values() for name in offer.options):
        if name not in own and name in options:
            default = options.parser.get_default(name)
            if getattr(options, name) != default:
                methods = [method for method, other in OFFERS.items() if name in other.options]
                raise InputError(
                    f"is for --method {', '.join(methods)}; the method is {method}, so "
                    "leave it out",
                    parameter=name,
                )
