"""Options made from the fields of classes of parameters (:mod:`stylit_ref.parameters`)."""

import argparse
from collections.abc import Callable
from dataclasses import Field
from typing import Any

from stylit_ref.parameters import Integer


def parsed(kind: Any) -> Callable[[str], Any]:
    """The ``type`` of an option for a kind of parameter (:mod:`stylit_ref.parameters`)."""

    def parse(text):
        try:
            return kind.parse(text)
        except ValueError:
            raise argparse.ArgumentTypeError(f"is {text!r}; it must be {kind.described}") from None

    return parse


whole_number: Callable[[str], Any] = parsed(Integer(0, 0))
"""The ``type`` of an option for an integer whose range the library checks."""


def add_parameter(
    group: argparse._ArgumentGroup, field: "Field[Any]", default: Any, flag: str | None = None
) -> None:
    """Add an option for a parameter, None where it is not given.

    Parameters
    ----------
    group : argparse._ArgumentGroup
    field : dataclasses.Field
        Made by :func:`stylit_ref.parameters.parameter`.
    default
        What is taken without the option, for the help.
    flag : str, optional
        Where the option is not spelled as its parameter.
    """
    in_python = f"{field.name} in Python, " if flag else ""
    group.add_argument(
        flag or f"--{field.name.replace('_', '-')}",
        dest=field.name,
        type=parsed(field.metadata["kind"]),
        metavar=field.metadata["kind"].placeholder,
        help=f"{field.metadata['text']} ({in_python}default {_shown(default)})",
    )


def _shown(value):
    if value is None:
        return "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, tuple):
        return ",".join(f"{each:g}" for each in value)
    return f"{value:g}" if isinstance(value, float) else value
