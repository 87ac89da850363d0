"""The one error a user can cause."""


class InputError(ValueError):
    """Input that cannot be used: one sentence says what was found and what is needed."""

    def __init__(self, sentence):
        super().__init__(one_line(sentence))


def one_line(text):
    """The text on one line, without what could act on a terminal.

    A file's name or another library's message may bring anything along.
    """
    return "".join(
        " " if sign.isspace() else sign if sign.isprintable() else "\ufffd" for sign in text
    )
