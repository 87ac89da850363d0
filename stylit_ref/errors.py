"""The error that bad input raises."""

from collections.abc import Iterable
from difflib import get_close_matches


class InputError(ValueError):
    """Input that cannot be used: one sentence says what was found and what is needed.

    Parameters
    ----------
    sentence : str
        A whole sentence; with ``parameter``, the rest of a sentence that begins with its name.
    parameter : str, optional
        Name of the refused parameter in the signature of the function that was called. A command
        line puts the name of its option before ``sentence`` instead.
    """

    def __init__(self, sentence: str, *, parameter: str | None = None) -> None:
        self.sentence: str = one_line(sentence)
        self.parameter: str | None = parameter
        super().__init__(f"{parameter} {self.sentence}" if parameter else self.sentence)


def one_line(text: str) -> str:
    """The text on one line, without control characters.

    A file's name or another library's message may contain characters that a terminal obeys.
    """
    return "".join(
        " " if sign.isspace() else sign if sign.isprintable() else "\ufffd" for sign in text
    )


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """The end of a refusal of a word: the known one that looks most like it, if one does."""
    found = get_close_matches(word, list(known), n=1)
    return f"; did you mean {found[0]}?" if found else ""


def shown(value: object) -> str:
    """A value as a refusal shows it: a text in quotes, so that '2' is not taken for 2."""
    return repr(value) if isinstance(value, str) else str(value)
