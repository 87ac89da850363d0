"""Pull a frame towards its neighbours: fold their pictures into its B' before a search."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.stylization.level import Level
from stylit_ref.views import passes
from stylit_ref.views.frames import Motion


class Neighbour(NamedTuple):
    """A picture that pulls at a frame.

    Attributes
    ----------
    places : (H, W, 2) int32
        Where each pixel of the frame lies in the picture; -1 where the picture does not show it.
    picture : (H, W, n) uint8
    """

    places: NDArray[np.int32]
    picture: NDArray[np.uint8]


def places_of(motion: Motion, depth: int) -> NDArray[np.int32]:
    """Where each pixel of a level lies in the neighbour.

    Parameters
    ----------
    motion : Motion
    depth : int
        How many levels are finer.

    Returns
    -------
    (H >> depth, W >> depth, 2) int32
        (y, x), or -1 where the neighbour does not show the point.
    """
    height, width = motion.visible.shape
    places = np.empty((height >> depth, width >> depth, 2), np.int32)
    passes.shift_map(motion.field, motion.visible, depth, places)
    return places


def without_masked(motion: Motion, mask: NDArray[np.bool_] | None) -> Motion:
    """Motion into a frame whose masked pixels show nothing.

    Parameters
    ----------
    motion : Motion
    mask : (H, W) bool or None
        Of the frame that it leads into.

    Returns
    -------
    Motion
    """
    if mask is None:
        return motion
    places = places_of(motion, 0)
    return Motion(motion.field, motion.visible & ~mask[places[:, :, 0], places[:, :, 1]])


def pull(
    level: Level,
    own: NDArray[np.uint8],
    neighbours: Sequence[Neighbour],
    weight: int,
    *,
    with_spread: bool,
) -> None:
    """Set the level's B' to M, for the next search; the next vote makes B' again.

    Parameters
    ----------
    level : Level
    own : (H, W, n) uint8
        B'. Without neighbours it stays.
    neighbours : sequence of Neighbour
    weight : int
        λ_c of each, in units of 1/256.
    with_spread : bool
        Whether the level's last guide takes the spread
        (:func:`stylit_ref.views.packing.coherent_packing`).
    """
    if not neighbours:
        level.set_style(own)
        return
    own = np.ascontiguousarray(own)
    guides = np.empty((len(neighbours), *own.shape), np.uint8)
    for neighbour, guide in zip(neighbours, guides, strict=True):
        passes.shift_picture(neighbour.picture, neighbour.places, own, guide)
    mixed, spreads = np.empty_like(own), np.empty((*own.shape[:2], 1), np.uint8)
    passes.fold(own, guides, np.full(len(neighbours), weight, np.int64), mixed, spreads)
    level.set_style(mixed, last_guide=spreads if with_spread else None)
