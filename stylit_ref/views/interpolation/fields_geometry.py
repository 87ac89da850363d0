"""Motion of views between others from that between the views themselves, without cameras."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.views import passes as frame_passes
from stylit_ref.views.frames import Edges, Motion
from stylit_ref.views.interpolation import passes
from stylit_ref.views.interpolation.axis import Between
from stylit_ref.views.interpolation.grid import Grid
from stylit_ref.views.interpolation.surface import Surface
from stylit_ref.views.motion.composition import composed


class _Seen(NamedTuple):
    """What is known of a view's points in the views around a cell, itself among them.

    ``numbers`` of frames, ``ways`` (N, H, W, 2) into them, where they are ``shown`` (N, H, W), and
    1 where any of them hides the point, ``hidden`` (H, W).
    """

    numbers: dict[int, int]
    ways: NDArray[np.float32]
    shown: NDArray[np.bool_]
    hidden: NDArray[np.float32]


@dataclass(frozen=True)
class FieldsGeometry:
    """Motion between neighbours in a grid.

    A point moves from view to view along the grid. Between four views it is where these four put
    it, in bilinear proportion. No faces are known, nor what lies in front: a point is masked in
    views that do not show it. Strokes beside a silhouette move as the motion has it.

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
        # Where no view tells anything, all are masked.
        motion = np.full((len(views), *self.size, 2), np.inf, np.float32)
        landed = np.zeros(self.size, np.bool_)
        moved = np.empty((*self.size, 2), np.float32)
        places, winners = (np.empty((*self.size, 2), np.int32) for _ in range(2))
        for view in views:
            seen, others, shares = self._around(place, view)
            passes.move(seen.ways, others, shares, landed, moved, places)
            # Of two points on one pixel the one that some view does not show is the one behind.
            frame_passes.splat(moved, places, seen.hidden, winners)
            order = np.array([seen.numbers[other] for other in views], np.int64)
            passes.follow(winners, moved, seen.ways, seen.shown, order, landed, motion)
        # What has come into view moves as what is closest to it.
        beside = np.empty((*self.size, 2), np.int32)
        passes.find_closest(landed, np.empty(self.size, np.int32), beside)
        return Surface(np.zeros(self.size, np.int32), beside), motion

    def _around(
        self, place: tuple[float, float], view: int
    ) -> tuple[_Seen, NDArray[np.int64], NDArray[np.float32]]:
        """What is known of a view's points, and the shares of the ways that lead to a place."""
        across, upwards = self.grid.between(place)
        (row, far_row, up), (column, far_column, right) = _sides(self.grid, view, across, upwards)
        frames = self.grid.frames
        others = frames[row][far_column], frames[far_row][column], frames[far_row][far_column]
        seen = self._view(view, *others)
        shares = np.array([right * (1 - up), up * (1 - right), right * up], np.float32)
        numbers = np.array([seen.numbers[other] for other in others], np.int64)
        counts = shares != 0  # a way that counts nothing may be no number
        return seen, numbers[counts], shares[counts]

    def _view(self, view: int, beside: int, above: int, corner: int) -> _Seen:
        key = view, beside, above, corner
        if key not in self._seen:
            still = Motion(np.zeros((*self.size, 2), np.float32), np.ones(self.size, np.bool_))
            found = {view: still}
            for other in (beside, above):
                if other != view:
                    found[other] = self.edges[view, other]
            if corner not in found:
                last = composed(found[beside], self.edges[beside, corner])
                # Where the way is hidden, the parts of a flat surface move alike.
                way = found[beside].field + found[above].field
                way = np.where(last.visible[..., None], last.field, way)
                found[corner] = last._replace(field=way)
            shown = np.stack([motion.visible for motion in found.values()])
            self._seen[key] = _Seen(
                {frame: number for number, frame in enumerate(found)},
                np.stack([motion.field for motion in found.values()]),
                shown,
                (~shown.all(axis=0)).astype(np.float32),
            )
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
