"""Motion between views by looking at a mesh."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stylit_ref.views.interpolation import passes
from stylit_ref.views.interpolation.camera import Camera
from stylit_ref.views.interpolation.formulae.transfer import plane_depths
from stylit_ref.views.interpolation.orbit import Orbit
from stylit_ref.views.interpolation.surface import SKY, Surface, motion_by_depth, surface_of
from stylit_ref.views.mesh import Mesh

NEAR = 0.01
"""What is nearer to a camera than that part of the way to its target is not seen."""


@dataclass(frozen=True)
class MeshGeometry:
    """A mesh, and the cameras around it.

    Attributes
    ----------
    mesh : Mesh
    orbit : Orbit
    size : tuple of 2 int
        Rows and columns of a view.
    """

    mesh: Mesh
    orbit: Orbit
    size: tuple[int, int]

    def view_labels(self) -> NDArray[np.int32]:
        """As :class:`~stylit_ref.views.interpolation.surface.Geometry`."""
        return np.stack([self._seen(camera)[0].spread_labels for camera in self.orbit.cameras])

    def look(
        self, place: tuple[float, float], views: Sequence[int]
    ) -> tuple[Surface, NDArray[np.float32]]:
        """As :class:`~stylit_ref.views.interpolation.surface.Geometry`."""
        camera = self.orbit.at(place)
        surface, inverse = self._seen(camera)
        transfers = self.orbit.transfers(camera.matrix(self.size), views, self.size)
        return surface, motion_by_depth(inverse, transfers)

    def _seen(self, camera: Camera) -> tuple[Surface, NDArray[np.float64]]:
        triangles, inverse = look_at_mesh(self.mesh, camera, self.size)
        return surface_of(labels_of(self.mesh, triangles), inverse), inverse


def labels_of(mesh: Mesh, triangles: NDArray[np.int32]) -> NDArray[np.int32]:
    """The faces of what :func:`look_at_mesh` sees, (H, W) int32."""
    return np.where(triangles < 0, SKY, mesh.groups[triangles]).astype(np.int32)


def look_at_mesh(
    mesh: Mesh, camera: Camera, size: tuple[int, int]
) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """What a camera sees of a mesh.

    Parameters
    ----------
    mesh : Mesh
    camera : Camera
    size : tuple of 2 int
        Rows and columns.

    Returns
    -------
    triangles : (H, W) int32
        The number of the triangle at every pixel, -1 where there is none.
    inverse : (H, W) float64
        1 / depth there, and 0 where there is none.
    """
    matrix, corners = camera.matrix(size), mesh.vertices[mesh.faces].astype(np.float64)
    distance = np.linalg.norm(np.subtract(camera.target, camera.origin))
    seen = corners @ matrix[:, :3].T + matrix[:, 3]
    polygons = np.empty((len(corners), 4, 2))
    counts = np.empty(len(corners), np.int32)
    passes.clip(seen, NEAR * distance, polygons, counts)
    # Zeros, since a rehearsal looks up the face of every triangle.
    triangles, inverse = np.zeros(size, np.int32), np.empty(size, np.float64)
    passes.rasterize(polygons, counts, plane_depths(matrix, corners), triangles, inverse)
    return triangles, inverse
