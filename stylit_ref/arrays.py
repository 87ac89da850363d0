"""Arrays of whatever a caller hands over."""

import numpy as np
from numpy.typing import ArrayLike

from stylit_ref.errors import InputError


def as_array(array: ArrayLike, name: str) -> np.ndarray:
    """The array, refused by its name where it is a sequence of unlike parts."""
    try:
        return np.asarray(array)
    except ValueError:
        raise InputError("is no array: its rows differ in length", parameter=name) from None
