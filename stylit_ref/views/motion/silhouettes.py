"""Strokes that leave a thing move with it, and not with what they are painted over.

An artist's outlines do not end where the geometry does. Beside a silhouette they lie on pixels of
the ground. With the motion of the ground they would stay behind, and coherence would draw them
there again: ghosts. So pixels beside something nearer take its motion, as far as strokes reach
(:func:`~stylit_ref.views.formulae.silhouette.reach_of`). One rule serves sequences and views.

Depth says what is nearer. IDs say where things end, and not which of two is nearer; only what has
no ID, 0, lies behind what has one. So IDs without depth serve in front of an empty background.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.views import passes
from stylit_ref.views.formulae.depth import inverse_depth
from stylit_ref.views.formulae.silhouette import STEP, is_nearer, reach_of
from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.places import fetched, places_in_other


class Silhouettes(NamedTuple):
    """What the pixels of a frame belong to, strokes beside silhouettes among them.

    Attributes
    ----------
    places : (H, W, 2) int32
        (y, x) of the pixel whose motion each takes: its own, or the closest of something nearer.
    beside : (H, W) bool
        Whether it is another one.
    inverse : (H, W) float64
        The inverse depth there; of IDs, 1 for what has one and 0 for what has none.
    """

    places: NDArray[np.int32]
    beside: NDArray[np.bool_]
    inverse: NDArray[np.float64]


def silhouettes_of(
    depth: NDArray[np.float32] | None, labels: NDArray[np.integer[Any]] | None = None
) -> Silhouettes | None:
    """Find the pixels of a frame beside something nearer.

    Parameters
    ----------
    depth : (H, W) float32 or None
        Farther is larger; where nothing is 0 or less, 10⁹ or more, infinite, or no number.
    labels : (H, W) of whole numbers, optional
        IDs; 0 where nothing is. They count where there is no depth.

    Returns
    -------
    Silhouettes or None
        None if neither is known.
    """
    if depth is not None:
        inverse = inverse_depth(depth)
    elif labels is not None:
        inverse = (labels != 0).astype(np.float64)
    else:
        return None
    places = places_beside(inverse)
    rows, columns = np.ogrid[: inverse.shape[0], : inverse.shape[1]]
    beside = (places[:, :, 0] != rows) | (places[:, :, 1] != columns)
    return Silhouettes(places, beside, fetched(inverse, places))


def places_beside(inverse: NDArray[np.float64]) -> NDArray[np.int32]:
    """Find the pixel that each pixel belongs to: its own, or that of something nearer beside it.

    Parameters
    ----------
    inverse : (H, W) float64
        1 / depth, 0 where nothing is.

    Returns
    -------
    (H, W, 2) int32
        (y, x).
    """
    from scipy.ndimage import maximum_filter  # imported late: SciPy takes long to load

    size = inverse.shape
    # Zeros, since a rehearsal looks up what is at every place.
    rims, places = np.zeros(size, np.bool_), np.zeros((*size, 2), np.int32)
    passes.find_rims(inverse, rims)
    reach = reach_of(*size)
    nearest = maximum_filter(np.where(rims, inverse, 0), 2 * reach + 1)
    passes.take_nearer(inverse, rims, is_nearer.py_func(nearest, inverse), reach, places)
    return places


def along_silhouettes(motion: Motion, here: Silhouettes, there: Silhouettes) -> Motion:
    """Let strokes beside silhouettes move with what they belong to.

    Parameters
    ----------
    motion : Motion
        From one frame into another.
    here, there : Silhouettes
        Of the two frames.

    Returns
    -------
    Motion
        Hidden also where a pixel or its place in the other frame lies beside a silhouette, and
        there is something else in the other frame.
    """
    taken = Motion(fetched(motion.field, here.places), fetched(motion.visible, here.places))
    places = places_in_other(taken)
    found = fetched(there.inverse, places)
    near, far = np.maximum(here.inverse, found), np.minimum(here.inverse, found)
    is_same = (near <= STEP**2 * far) | ~(here.beside | fetched(there.beside, places))
    return Motion(taken.field, taken.visible & is_same)
