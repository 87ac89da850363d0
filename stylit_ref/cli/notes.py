"""What is worth a note but stops nothing."""

import logging
import sys
import warnings
from contextlib import contextmanager

from stylit_ref.errors import one_line


class _Notes(logging.Handler):
    """Prints each text once."""

    def __init__(self):
        super().__init__(logging.INFO)
        self._said = set()

    def emit(self, record):
        self.say(record.getMessage())

    def say(self, text):
        if text not in self._said:
            self._said.add(text)
            print(f"note: {one_line(text)}", file=sys.stderr)


@contextmanager
def notes_on_stderr():
    """Print what the library logs or warns of while the block runs, a line each, and each once."""
    notes, logger = _Notes(), logging.getLogger("stylit_ref")
    level = logger.level
    logger.addHandler(notes)
    logger.setLevel(logging.INFO)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("always", UserWarning)
            warnings.showwarning = lambda message, *_: notes.say(str(message))
            yield
    finally:
        logger.setLevel(level)
        logger.removeHandler(notes)
