"""The one error a user can cause."""


class InputError(ValueError):
    """Input that cannot be used: one sentence says what was found and what is needed."""
