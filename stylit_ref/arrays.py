"""Turn a caller's argument into an array."""

import numpy as np
from numpy.typing import ArrayLike

from stylit_ref.errors import InputError


def as_array(array: ArrayLike, name: str) -> np.ndarray:
    """The argument as an array; an InputError if its rows differ in length."""
    try:
        return np.asarray(array)
    except ValueError:
        raise InputError("is not an array: its rows differ in length", parameter=name) from None
