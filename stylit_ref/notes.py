"""What a user may want to know: records of the logger ``stylit_ref``, each sentence once.

A record of level INFO tells of a harmless choice, one of level WARNING of a result that may not be
the one that was meant. Its attributes ``parameter`` and ``sentence`` are those of an
:class:`stylit_ref.errors.InputError`.
"""

import logging

from stylit_ref.errors import one_line


class Once(logging.Filter):
    """Lets a sentence through once: a pipeline makes the same call for every frame.

    Attributes
    ----------
    said : set of str
        The sentences that came through.
    """

    def __init__(self) -> None:
        super().__init__()
        self.said: set[str] = set()

    def filter(self, record: logging.LogRecord) -> bool:
        """Whether nobody has seen the record's sentence."""
        sentence = record.getMessage()
        is_new = sentence not in self.said
        self.said.add(sentence)
        return is_new


ONCE = Once()
LOGGER = logging.getLogger("stylit_ref")
LOGGER.addFilter(ONCE)


def note(sentence: str, *, parameter: str | None = None, level: int = logging.INFO) -> None:
    """Tell the user something that is no reason to stop.

    Parameters
    ----------
    sentence : str
        A whole sentence; with ``parameter`` what follows that name.
    parameter : str, optional
        Name of the parameter that the note is about, as in the signature of what was called.
    level : int
        ``logging.INFO`` or ``logging.WARNING``.
    """
    sentence = one_line(sentence)
    text = f"{parameter} {sentence}" if parameter else sentence
    LOGGER.log(
        level, "%s", text, extra={"parameter": parameter, "sentence": sentence}, stacklevel=2
    )
