"""Turn a caller's argument into an array."""

import numpy as np

from stylit_ref.errors import InputError


def as_array(array, name):
    """The argument as an array; an InputError if its rows differ in length."""
    try:
        return np.asarray(array)
    except ValueError:
        raise InputError(f"{name} is not an array: its rows differ in length") from None
