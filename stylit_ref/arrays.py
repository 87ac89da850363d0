"""Arrays of whatever a caller hands over."""

import numpy as np

from stylit_ref.errors import InputError


def as_array(array, name):
    """The array, refused where it is a sequence of unlike parts."""
    try:
        return np.asarray(array)
    except ValueError:
        raise InputError(f"{name} is no array: its rows differ in length") from None
