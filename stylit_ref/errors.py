"""The one error a user can cause."""


class InputError(ValueError):
    """Input that cannot be used: one sentence says what was found and what is needed.

    One line, whatever a file's name or another library's message brings along.
    """

    def __init__(self, sentence):
        super().__init__(" ".join(sentence.split("\n")))
