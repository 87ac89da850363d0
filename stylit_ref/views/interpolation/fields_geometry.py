"""Motion of views between others from that between the views themselves, without cameras."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

from stylit_ref.views import passes
from stylit_ref.views.frames import Edges, Motion
from stylit_ref.views.interpolation.axis import Between
from stylit_ref.views.interpolation.grid import Grid
from stylit_ref.views.interpolation.surface import Surface
from stylit_ref.views.motion.composition import composed
from stylit_ref.views.motion.places import fetched, places_in_other


class _Seen(NamedTuple):
    """Where the pixels of a view lie in the other views around, and which of those show them."""

    ways: dict[int, NDArray[np.float32]]
    shown: dict[int, NDArray[np.bool_]]


@dataclass(frozen=True)
class FieldsGeometry:
    """Motion between neighbours in a grid.

    A point moves from view to view along the grid. Between four views it is where these four put
    it, in bilinear proportion. No faces are known, nor what lies in front: a point is masked in
    views that do not show it, and strokes beside a silhouette move with what lies behind them.

    Attributes
    ----------
    edges : mapping of (int, int) to Motion
        Between all neighbours, both ways.
    grid : Grid
    size : tuple of 2 int
        Rows and columns of a view.
    """

    edges: Edges
    grid: Grid
    size: tuple[int, int]
    _seen: dict[tuple[int, ...], _Seen] = field(default_factory=dict)

    def view_labels(self) -> NDArray[np.int32]:
        """As :class:`~stylit_ref.views.interpolation.surface.Geometry`; all of one face."""
        return np.zeros((np.size(self.grid.frames), *self.size), np.int32)

    def look(
        self, place: tuple[float, float], views: Sequence[int]
    ) -> tuple[Surface, NDArray[np.float32]]:
        """As :class:`~stylit_ref.views.interpolation.surface.Geometry`."""
        motion = np.full((len(views), *self.size, 2), np.inf, np.float32)
        landed = np.zeros(self.size, np.bool_)
        for view in views:
            moved, seen, is_everywhere = self._moved(place, view)
            winners = np.empty((*self.size, 2), np.int32)
            # Two points on one pixel: the one that a view does not show is the one behind.
            passes.splat(moved.field, places_in_other(moved), is_everywhere, winners)
            new = (winners[:, :, 0] >= 0) & ~landed
            landed |= new
            for k, other in enumerate(views):
                way = fetched(seen.ways[other] - moved.field, winners)
                motion[k][new] = np.where(fetched(seen.shown[other], winners)[..., None], way,
                                          np.inf)[new]  # fmt: skip
        # What has come into view moves as what is closest to it.
        closest = distance_transform_edt(~landed, return_distances=False, return_indices=True)
        beside = np.ascontiguousarray(np.moveaxis(closest, 0, -1), np.int32)
        return Surface(np.zeros(self.size, np.int32), beside), motion

    def _moved(self, place, view):
        """The motion of a view's pixels to a place, and what is known of them elsewhere."""
        across, upwards = self.grid.between(place)
        (row, far_row, up), (column, far_column, right) = _sides(self.grid, view, across, upwards)
        frames = self.grid.frames
        beside, above = frames[row][far_column], frames[far_row][column]
        corner = frames[far_row][far_column]
        seen = self._view(view, beside, above, corner)
        ways = [seen.ways[other].astype(np.float64) for other in (beside, above, corner)]
        total = right * (1 - up) * ways[0] + up * (1 - right) * ways[1] + right * up * ways[2]
        hidden = ~np.logical_and.reduce(list(seen.shown.values()))
        everywhere = np.ones(self.size, np.bool_)
        return Motion(total.astype(np.float32), everywhere), seen, hidden.astype(np.float32)

    def _view(self, view, beside, above, corner):
        key = view, beside, above, corner
        if key not in self._seen:
            still = Motion(np.zeros((*self.size, 2), np.float32), np.ones(self.size, np.bool_))
            along, up = (
                self.edges[view, other] if other != view else still for other in (beside, above)
            )
            if corner in (beside, above):
                last = along if corner == beside else up
            else:
                last = composed(along, self.edges[beside, corner])
                # Where the way is hidden, the parts of a flat surface move alike.
                way = np.where(last.visible[..., None], last.field, along.field + up.field)
                last = last._replace(field=way)
            self._seen[key] = _Seen(
                {above: up.field, beside: along.field, corner: last.field, view: still.field},
                {above: up.visible, beside: along.visible, corner: last.visible,
                 view: still.visible},
            )  # fmt: skip
        return self._seen[key]


def _sides(grid: Grid, view: int, across: Between, upwards: Between):
    """The row and the column of a view, those on the other side, and how far the place is."""
    found = []
    row, column = next(
        (row, column)
        for row in (upwards.low, upwards.high)
        for column in (across.low, across.high)
        if grid.frames[row][column] == view
    )
    for own, between in ((row, upwards), (column, across)):
        far = between.high if own == between.low else between.low
        width = between.high_at - between.low_at
        share = (between.at - between.low_at) / width if width else 0.0
        found.append((own, far, share if own == between.low else 1 - share))
    return found
