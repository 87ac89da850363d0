"""The way back: a field of this frame's pixels, made a field of the other frame's pixels."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.views import passes
from stylit_ref.views.formulae.depth import depth_of_things
from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.places import fetched, places_in_other


def inverted(motion: Motion, depth: NDArray[np.float32] | None = None) -> Motion:
    """Turn a field around by splatting.

    Each pixel lands on the pixel that its motion leads to, and leaves the opposite motion there. If
    pixels of different motion land on one, the nearest wins by depth. Without depth nothing says
    which is nearer, and the pixel is hidden. Where nothing lands the pixel is hidden too, but for
    cracks of one pixel within a surface that has come nearer.

    Parameters
    ----------
    motion : Motion
        From this frame into another.
    depth : (H, W) float32, optional
        Of this frame; farther is larger. What renderers write where nothing is counts as infinite
        (:mod:`stylit_ref.views.formulae.depth`).

    Returns
    -------
    Motion
        From the other frame into this one.
    """
    places = places_in_other(motion)
    winners, _, contested = _landed(motion, places, depth)
    shown = winners[:, :, 0] >= 0
    field = np.where(shown[:, :, None], -fetched(motion.field, winners), np.float32(0))
    if depth is None:
        shown &= ~contested
    return _without_cracks(Motion(field + np.float32(0), shown), winners[:, :, 0] < 0, motion)


def unhidden(motion: Motion, depth: NDArray[np.float32] | None = None) -> NDArray[np.bool_]:
    """The pixels that no other pixel of the frame covers in the other frame.

    Parameters
    ----------
    motion : Motion
    depth : (H, W) float32, optional
        As of :func:`inverted`. Without it, all pixels of different motion that land on one are
        hidden, since nothing says which is nearer.

    Returns
    -------
    (H, W) bool
        False also for pixels that lead nowhere.
    """
    places = places_in_other(motion)
    _, beaten, contested = _landed(motion, places, depth)
    landed = places[:, :, 0] >= 0
    return landed & ~(fetched(contested, places) if depth is None else beaten)


def _landed(motion, places, depth):
    size = motion.visible.shape
    winners = np.empty((*size, 2), np.int32)
    distances = np.zeros(size) if depth is None else depth_of_things(depth)
    passes.splat(motion.field, places, np.ascontiguousarray(distances, np.float32), winners)
    beaten, contested = np.empty(size, np.bool_), np.empty(size, np.bool_)
    passes.find_beaten(motion.field, places, winners, beaten, contested)
    return winners, beaten, contested


def _without_cracks(back: Motion, empty: NDArray[np.bool_], motion: Motion) -> Motion:
    """Fill a pixel on which nothing landed between two neighbours of the same motion.

    It must lead to a pixel that moves along with it; otherwise something else was uncovered.
    """
    field, shown = back.field.copy(), back.visible.copy()
    for turned in (False, True):  # cracks that run down, then those that run across
        vectors, seen, gap = (
            array.swapaxes(0, 1) if turned else array for array in (field, shown, empty)
        )
        alike = (np.abs(vectors[:, :-2] - vectors[:, 2:]) <= 1).all(axis=2)
        crack = gap[:, 1:-1] & seen[:, :-2] & seen[:, 2:] & alike
        vectors[:, 1:-1][crack] = vectors[:, :-2][crack]
        seen[:, 1:-1] |= crack
    filled = Motion(field, shown)
    places = places_in_other(filled)
    moves_along = (np.abs(fetched(motion.field, places) + field) <= 1).all(axis=2)
    moves_along &= (places[:, :, 0] >= 0) & fetched(motion.visible, places)
    return Motion(field, shown & (moves_along | back.visible))
