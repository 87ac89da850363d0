"""What a camera sees: a face and a depth at every pixel, and what strokes beside it belong to."""

from collections.abc import Sequence
from typing import Literal, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from stylit_ref.views.interpolation import passes
from stylit_ref.views.motion.places import fetched
from stylit_ref.views.motion.silhouettes import places_beside

SKY = -1
"""The label where nothing is."""


class Surface(NamedTuple):
    """What a view shows.

    Attributes
    ----------
    labels : (H, W) int32
        The face of every pixel, -1 where nothing is.
    beside : (H, W, 2) int32
        (y, x) of the pixel that each belongs to: its own, or that of something nearer which it lies
        beside, as far as strokes reach.
    """

    labels: NDArray[np.int32]
    beside: NDArray[np.int32]

    @property
    def spread_labels(self) -> NDArray[np.int32]:
        """The faces, those beside silhouettes taken from what they belong to."""
        return fetched(self.labels, self.beside)


GeometryKind = Literal["mesh", "positions", "fields"]
"""What the motion of views between others comes from: a mesh, the positions of the points that
views show, or the motion between neighbours."""


class Geometry(Protocol):
    """Whatever tells the motion of views between those of a grid."""

    def view_labels(self) -> NDArray[np.int32]:
        """The faces of every view of the grid, spread beside silhouettes: (N, H, W) int32."""
        ...

    def look(
        self, place: tuple[float, float], views: Sequence[int]
    ) -> tuple[Surface, NDArray[np.float32]]:
        """What is seen from a place, and its motion into some views.

        Parameters
        ----------
        place : tuple of 2 float
            To the right and upwards, from the middle of the grid.
        views : sequence of K int
            Those around it, the closest first.

        Returns
        -------
        surface : Surface
        motion : (K, H, W, 2) float32
            (x, y) in pixels, to be added to a pixel.
        """
        ...


def surface_of(labels: NDArray[np.int32], inverse: NDArray[np.float64]) -> Surface:
    """A surface with what lies beside its silhouettes.

    Parameters
    ----------
    labels : (H, W) int32
    inverse : (H, W) float64
        1 / depth, 0 where nothing is.
    """
    return Surface(labels, places_beside(inverse))


def motion_by_depth(
    inverse: NDArray[np.float64], transfers: NDArray[np.float64]
) -> NDArray[np.float32]:
    """The motion of every pixel into K views, (K, H, W, 2) float32."""
    motion = np.empty((len(transfers), *inverse.shape, 2), np.float32)
    passes.transfer(inverse, transfers, motion)
    return motion
