"""What is worth a note but stops nothing."""

import argparse
import logging
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager

from stylit_ref.errors import one_line
from stylit_ref.notes import LOGGER


class _Notes(logging.Handler):
    """Prints the notes of the library, a parameter by the option that sets it.

    What is harmless about a parameter that nobody has typed is no news.
    """

    def __init__(self, options):
        super().__init__(logging.INFO)
        self._options = options

    def emit(self, record):
        name = getattr(record, "parameter", None)  # others may log there too
        if record.levelno < logging.WARNING and getattr(self._options, name or "", "") is None:
            return
        flag = f"{self._options.parser.flag_of(name)} " if name else ""
        say(f"{flag}{getattr(record, 'sentence', record.getMessage())}")


def say(text: str) -> None:
    """Print a note."""
    print(f"note: {one_line(text)}", file=sys.stderr)


@contextmanager
def notes_on_stderr(options: argparse.Namespace) -> Iterator[None]:
    """Print what the library has to tell while the block runs, a line each.

    Parameters
    ----------
    options : argparse.Namespace
        With the ``parser`` that they come from.
    """
    notes, level = _Notes(options), LOGGER.level
    LOGGER.addHandler(notes)
    LOGGER.setLevel(logging.INFO)
    try:
        with warnings.catch_warnings():  # of other libraries
            warnings.simplefilter("once", UserWarning)
            warnings.showwarning = lambda message, *_: say(str(message))
            yield
    finally:
        LOGGER.setLevel(level)
        LOGGER.removeHandler(notes)
