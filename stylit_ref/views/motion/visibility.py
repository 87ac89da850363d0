"""What the other frame shows of a frame's points, where no mask tells it."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from stylit_ref.views import passes
from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.places import fetched, places_in_other


def cancelling(motion: Motion, back: Motion) -> NDArray[np.bool_]:
    """The pixels whose motion forth and back cancels, by the rule of Sundaram et al. (2010).

    A point that the other frame hides leads to what hides it, and that moves in another way.

    Parameters
    ----------
    motion : Motion
        From this frame into the other.
    back : Motion
        From the other into this one.

    Returns
    -------
    (H, W) bool
    """
    cancels = np.empty(motion.visible.shape, np.bool_)
    places = places_in_other(motion)
    passes.cancel(motion.field, places, back.field, back.visible, cancels)
    return cancels


def same_labels(
    motion: Motion, labels: NDArray[np.integer[Any]], other: NDArray[np.integer[Any]]
) -> NDArray[np.bool_]:
    """The pixels that lead to a pixel of the same ID.

    Parameters
    ----------
    motion : Motion
    labels : (H, W) integers
        IDs of this frame.
    other : (H, W) integers
        Those of the other.

    Returns
    -------
    (H, W) bool
    """
    places = places_in_other(motion)
    return (places[:, :, 0] >= 0) & (fetched(other, places) == labels)
