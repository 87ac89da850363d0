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

    What is harmless is no news where nobody has typed the parameter, or with ``--quiet``.
    """

    def __init__(self, options):
        super().__init__(logging.INFO)
        self._options, self._quiet = options, getattr(options, "quiet", False)

    def emit(self, record):
        name = getattr(record, "parameter", None)  # others may log there too
        is_default = getattr(self._options, name or "", "") is None
        if record.levelno < logging.WARNING and (is_default or self._quiet):
            return
        flag = f"{self._options.parser.flag_of(name)} " if name else ""
        say(f"{flag}{getattr(record, 'sentence', record.getMessage())}")


def say(text: str) -> None:
    """Print a note."""
    from tqdm import tqdm  # imported late: most runs have nothing to tell

    tqdm.write(f"note: {one_line(text)}", file=sys.stderr)  # above a bar, if there is one


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
