"""Motion between views from passes of positions, where there is no mesh, or a huge one."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stylit_ref.views.interpolation import passes
from stylit_ref.views.interpolation.camera import Camera
from stylit_ref.views.interpolation.formulae.transfer import rays_of
from stylit_ref.views.interpolation.mesh_geometry import labels_of, look_at_mesh
from stylit_ref.views.interpolation.orbit import Orbit
from stylit_ref.views.interpolation.surface import Surface, motion_by_depth, surface_of
from stylit_ref.views.mesh import Mesh
from stylit_ref.views.positions import Positions

SLACK = 0.1
"""A point that lands on the corner of a pixel counts as 5 % farther away than one in its middle."""


@dataclass(frozen=True)
class PositionsGeometry:
    """What every view of a grid shows, point by point.

    Attributes
    ----------
    points : (N, H, W, 3) float32
        In the scene.
    labels : (N, H, W) int32
        -1 where nothing is.
    orbit : Orbit
    """

    points: NDArray[np.float32]
    labels: NDArray[np.int32]
    orbit: Orbit

    def view_labels(self) -> NDArray[np.int32]:
        """As :class:`~stylit_ref.views.interpolation.surface.Geometry`."""
        size = self.labels.shape[1:]
        spread = []
        for camera, points, labels in zip(
            self.orbit.cameras, self.points, self.labels, strict=True
        ):
            forward = camera.matrix(size)[2]
            depth = points.astype(np.float64) @ forward[:3] + forward[3]
            is_seen = (labels >= 0) & (depth > 0)
            inverse = np.where(is_seen, 1 / np.where(is_seen, depth, 1), 0)
            spread.append(surface_of(labels, inverse).spread_labels)
        return np.stack(spread)

    def look(
        self, place: tuple[float, float], views: Sequence[int]
    ) -> tuple[Surface, NDArray[np.float32]]:
        """As :class:`~stylit_ref.views.interpolation.surface.Geometry`."""
        size = self.labels.shape[1:]
        matrix = self.orbit.at(place).matrix(size)
        found, inverse = self.splatted(matrix, views)
        transfers = self.orbit.transfers(matrix, views, size)
        return surface_of(found, inverse), motion_by_depth(inverse, transfers)

    def splatted(
        self, matrix: NDArray[np.float64], views: Sequence[int]
    ) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
        """Labels, -1 where nothing is, and inverse depths of what a camera sees."""
        size = self.labels.shape[1:]
        sparse, far = np.empty(size, np.int32), np.empty(size, np.float64)
        views = np.array(views, np.int64)
        passes.splat_points(self.points, self.labels, views, matrix, SLACK, sparse, far)
        found, inverse = np.empty_like(sparse), np.empty_like(far)
        passes.fill_holes(sparse, far, found, inverse)
        return found, inverse


def positions_of_mesh(mesh: Mesh, camera: Camera, size: tuple[int, int]) -> Positions:
    """The pass of positions that a renderer would make of a mesh.

    Parameters
    ----------
    mesh : Mesh
    camera : Camera
    size : tuple of 2 int
        Rows and columns.
    """
    triangles, inverse = look_at_mesh(mesh, camera, size)
    rays, eye = rays_of(camera.matrix(size))
    y, x = np.mgrid[: size[0], : size[1]]
    seen = triangles >= 0
    depth = 1 / np.where(seen, inverse, 1)
    points = eye + depth[..., None] * (np.stack([x, y, np.ones_like(x)], axis=-1) @ rays.T)
    return Positions(points.astype(np.float32), labels_of(mesh, triangles))


def splatting_error(
    geometry: PositionsGeometry, mesh: Mesh, place: tuple[float, float]
) -> tuple[float, float]:
    """How much splatting differs from the mesh itself, seen from a place.

    Parameters
    ----------
    geometry : PositionsGeometry
        Made of the mesh.
    mesh : Mesh
    place : tuple of 2 float

    Returns
    -------
    holes, wrong : float
        The shares of pixels that show nothing, and another face, where the mesh shows one.
    """
    size = geometry.labels.shape[1:]
    camera = geometry.orbit.at(place)
    true = positions_of_mesh(mesh, camera, size).labels
    views = geometry.orbit.grid.around(place, 0.0).views
    found, _ = geometry.splatted(camera.matrix(size), views)
    holes = (found < 0) & (true >= 0)
    return float(holes.mean()), float(((found != true) & ~holes).mean())
