"""Kinds of parameters: which values are allowed, in Python and as text on a command line.

A class of parameters is a frozen dataclass whose fields are made by :func:`parameter`; each system
has its own. The kind of a field refuses other values, and turns NumPy's numbers and fractions into
Python's own numbers, so that equal values have the same ``repr``.
"""

from dataclasses import dataclass, field, fields, replace
from numbers import Integral, Real
from typing import Any, ClassVar

import numpy as np

from stylit_ref.errors import InputError, did_you_mean, shown

SPELLED = {
    "patch_width": "--patch-size",
    "levels": "--pyramid-levels",
    "votes": "--search-vote-iters",
    "patchmatch_iterations": "--patchmatch-iters",
}
"""Options of ``run`` that are not spelled as their parameters, but as users of ebsynth and StyLit
know them."""


def parameter(default: Any, kind: Any, text: str) -> Any:
    """Make a field of a class of parameters.

    Parameters
    ----------
    default
    kind : Integer, Number, Choice, ...
    text : str
        A few words on the parameter, for a command line's help.
    """
    return field(default=default, metadata={"kind": kind, "text": text})


def check_fields(params: Any) -> None:
    """Check and simplify the value of every field by its kind; call it from ``__post_init__``.

    Raises
    ------
    InputError
        If a value does not fit its kind.
    """
    for each in fields(params):
        value = each.metadata["kind"].check(each.name, getattr(params, each.name))
        object.__setattr__(params, each.name, value)


def option_words(name: str, value: Any) -> list[str]:
    """A parameter as the command line of ``run`` gives it: its option, and what it reads as value.

    Parameters
    ----------
    name : str
    value
        Any but None, which no option gives.
    """
    return [SPELLED.get(name, f"--{name.replace('_', '-')}"), _text_of(value)]


@dataclass(frozen=True)
class Integer:
    """An integer from ``least`` to ``most``, odd if ``odd``; ``remark`` ends the error message."""

    least: int
    most: int
    odd: bool = False
    remark: str = ""

    def check(self, name: str, value: Any) -> int:
        """The value as an int."""
        fits = isinstance(value, Integral) and self.least <= value <= self.most
        if not fits or (self.odd and value % 2 == 0):
            what = "an odd integer" if self.odd else "an integer"
            raise InputError(
                f"is {shown(value)}; it must be {what} from {self.least} to {self.most}"
                f"{self.remark}",
                parameter=name,
            )
        return int(value)

    parse: ClassVar[type[int]] = int
    described: ClassVar[str] = "an integer"
    placeholder: ClassVar[str] = "N"


@dataclass(frozen=True)
class Number:
    """A number from ``least`` to ``most``."""

    least: float
    most: float

    def check(self, name: str, value: Any) -> float:
        """The value as a float."""
        if not isinstance(value, Real) or not self.least <= value <= self.most:
            raise InputError(
                f"is {shown(value)}; it must be a number from {self.least:g} to {self.most:g}",
                parameter=name,
            )
        return float(value)

    parse: ClassVar[type[float]] = float
    described: ClassVar[str] = "a number"
    placeholder: ClassVar[str] = "X"


@dataclass(frozen=True)
class Share:
    """A number above 0 and up to 1; ``remark`` ends the error message."""

    remark: str = ""

    def check(self, name: str, value: Any) -> float:
        """The value as a float."""
        if not isinstance(value, Real) or not 0 < value <= 1:
            raise InputError(
                f"is {shown(value)}; it must be a number above 0 and up to 1{self.remark}",
                parameter=name,
            )
        return float(value)

    parse: ClassVar[type[float]] = float
    described: ClassVar[str] = "a number"
    placeholder: ClassVar[str] = "SHARE"


@dataclass(frozen=True)
class OrWord:
    """A value of a kind, or a word."""

    word: str
    kind: Integer | Share

    def check(self, name: str, value: Any) -> float | str:
        """The value, or the word."""
        if isinstance(value, str) and value == self.word:
            return value
        return replace(self.kind, remark=f", or {self.word!r}").check(name, value)

    def parse(self, text: str) -> float | str:
        """The word, or a value."""
        return text if text == self.word else self.kind.parse(text)

    @property
    def described(self) -> str:
        """What text must be."""
        return f"{self.word} or {self.kind.described}"

    @property
    def placeholder(self) -> str:
        """What stands for a value in a help text."""
        return self.kind.placeholder


@dataclass(frozen=True)
class Choice:
    """One of some names."""

    names: tuple[str, ...]

    def check(self, name: str, value: Any) -> str:
        """The value."""
        if not isinstance(value, str) or value not in self.names:
            *others, last = map(repr, self.names)
            raise InputError(
                f"is {shown(value)}; it must be {', '.join(others)} or {last}"
                f"{did_you_mean(str(value), self.names)}",
                parameter=name,
            )
        return value

    parse: ClassVar[type[str]] = str
    described: ClassVar[str] = "a name"
    placeholder: ClassVar[str] = "NAME"


@dataclass(frozen=True)
class Flag:
    """True or False."""

    placeholder: ClassVar[str] = "yes|no"
    described: ClassVar[str] = "yes or no"

    def check(self, name: str, value: Any) -> bool:
        """The value as a bool."""
        if not isinstance(value, bool | np.bool_):
            raise InputError(f"is {shown(value)}; it must be True or False", parameter=name)
        return bool(value)

    def parse(self, text: str) -> bool:
        """Yes or no."""
        if text not in ("yes", "no"):
            raise ValueError(f"{text!r} is neither")
        return text == "yes"


@dataclass(frozen=True)
class OneOrSeveral:
    """A value of a kind, or several of them."""

    kind: Integer | Number
    placeholder: ClassVar[str] = "N[,N...]"

    def check(self, name: str, value: Any) -> float | tuple[float, ...]:
        """The value, or a tuple of values."""
        if not (_is_sequence(value) and len(value)):
            return self.kind.check(name, value)
        return tuple(self.kind.check(name, each) for each in value)

    def parse(self, text: str) -> float | tuple[float, ...]:
        """A value, or a tuple of values if the text has commas."""
        values = tuple(self.kind.parse(part) for part in text.split(","))
        return values if len(values) > 1 else values[0]

    @property
    def described(self) -> str:
        """What text must be."""
        return f"{self.kind.described}, or several with commas between"


@dataclass(frozen=True)
class Several:
    """A sequence of values of a kind; messages call each ``one`` and its number."""

    kind: Integer | Number
    one: str
    placeholder: ClassVar[str] = "N[,N...]"

    def check(self, name: str, value: Any) -> tuple[float, ...]:
        """A tuple of values."""
        if not _is_sequence(value):
            raise InputError(f"is {shown(value)}; it must be a list of numbers", parameter=name)
        return tuple(self.kind.check(f"{self.one} {k}", each) for k, each in enumerate(value, 1))

    def parse(self, text: str) -> tuple[float, ...]:
        """A tuple of the values between commas."""
        return tuple(self.kind.parse(part) for part in text.split(","))

    @property
    def described(self) -> str:
        """What text must be."""
        return f"{self.kind.described}, or several with commas between"


@dataclass(frozen=True)
class Optional:
    """A value of a kind, or None."""

    kind: Any

    def check(self, name: str, value: Any) -> Any:
        """The value, or None."""
        return None if value is None else self.kind.check(name, value)

    def parse(self, text: str) -> Any:
        """A value."""
        return self.kind.parse(text)

    @property
    def described(self) -> str:
        """What text must be."""
        return self.kind.described

    @property
    def placeholder(self) -> str:
        """What stands for a value in a help text."""
        return self.kind.placeholder


def _text_of(value):
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, tuple):
        return ",".join(map(_text_of, value))
    return str(int(value)) if isinstance(value, float) and value.is_integer() else str(value)


def _is_sequence(value):
    try:
        return np.ndim(value) == 1
    except ValueError:  # rows of different lengths
        return False
