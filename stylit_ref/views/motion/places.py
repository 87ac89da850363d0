"""Follow a field to the pixels it leads to."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from stylit_ref.views import passes
from stylit_ref.views.frames import Motion


def places_in_other(motion: Motion) -> NDArray[np.int32]:
    """The pixel of the other frame that each pixel leads to.

    Parameters
    ----------
    motion : Motion

    Returns
    -------
    (H, W, 2) int32
        (y, x), rounded half up, or -1 where the other frame does not show the point.
    """
    places = np.zeros(motion.field.shape, np.int32)  # since a rehearsal looks up what is there
    passes.shift_map(motion.field, motion.visible, 0, places)
    return places


def fetched(values: NDArray[Any], places: NDArray[np.int32]) -> NDArray[Any]:
    """The values at places; those of pixels that lead nowhere mean nothing.

    Parameters
    ----------
    values : (H, W, ...) array
    places : (H, W, 2) int32

    Returns
    -------
    (H, W, ...) array
    """
    height, width = values.shape[:2]
    # One index in place of two: NumPy then fetches three times as fast.
    indices = np.maximum(places[:, :, 0], 0) * np.int64(width) + np.maximum(places[:, :, 1], 0)
    return values.reshape(height * width, *values.shape[2:]).take(indices, axis=0)
