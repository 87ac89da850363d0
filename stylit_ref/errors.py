"""The one error a user can cause."""


class InputError(ValueError):
    """Input that cannot be used: one sentence says what was found and what is needed.

    Parameters
    ----------
    sentence : str
        A whole sentence; with ``parameter`` what follows that name.
    parameter : str, optional
        Name of the parameter that is refused, as in the signature of what was called. A program
        with other names, as a command line has them, puts its own before ``sentence``.
    """

    def __init__(self, sentence, *, parameter=None):
        self.sentence, self.parameter = one_line(sentence), parameter
        super().__init__(f"{parameter} {self.sentence}" if parameter else self.sentence)


def one_line(text):
    """The text on one line, without what could act on a terminal.

    A file's name or another library's message may bring anything along.
    """
    return "".join(
        " " if sign.isspace() else sign if sign.isprintable() else "\ufffd" for sign in text
    )
