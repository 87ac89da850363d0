"""What views between others are worth: change along a path, sharpness, outlines and ghosts.

Change is measured along the true motion between two places, which the mesh tells. Outlines are
dark pixels beside what stands on the ground; dark pixels farther away are ghosts of strokes that
moved with the ground.
"""

from typing import NamedTuple

import numpy as np
from scipy.ndimage import binary_dilation

from eval.flicker import warp_error
from stylit_ref.views.formulae.silhouette import reach_of
from stylit_ref.views.frames import Motion
from stylit_ref.views.interpolation.formulae.transfer import transfer_of
from stylit_ref.views.interpolation.mesh_geometry import MeshGeometry, look_at_mesh
from stylit_ref.views.interpolation.positions_geometry import positions_of_mesh
from stylit_ref.views.interpolation.surface import Surface, motion_by_depth
from stylit_ref.views.motion.places import places_in_other

DARK = 192
"""A pixel is dark if its luma is less."""

_LUMA = np.array([0.299, 0.587, 0.114])


class Looks(NamedTuple):
    """What a picture looks like.

    Attributes
    ----------
    sharpness : float
        Mean gradient of luma, down plus across, in 8-bit steps.
    outlines, ghosts : float
        The shares of dark pixels beside things, and farther away on the ground.
    """

    sharpness: float
    outlines: float
    ghosts: float


class Truth:
    """What is seen from places, by the mesh.

    Parameters
    ----------
    geometry : MeshGeometry
    """

    def __init__(self, geometry):
        self.geometry = geometry
        mesh, size = geometry.mesh, geometry.size
        corners = mesh.vertices[mesh.faces].astype(np.float64)
        areas = np.linalg.norm(
            np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
        )
        self._ground = np.bincount(mesh.groups, areas).argmax()
        self._reach = reach_of(*size)

    def change(self, before, after, place, next_place):
        """How much the points have changed that both pictures show, in 8-bit steps.

        Parameters
        ----------
        before, after : (H, W, n) uint8
        place, next_place : tuple of 2 float
        """
        here, there = self._labels(place), self._labels(next_place)
        motion = self._motion(place, next_place)
        places = places_in_other(Motion(motion, np.ones(motion.shape[:2], np.bool_)))
        inside = places[:, :, 0] >= 0
        seen = inside & (there[places[:, :, 0], places[:, :, 1]] == here)
        return warp_error(before, after, motion, seen)

    def looks(self, picture, place):
        """Sharpness, outlines and ghosts of a picture of a place."""
        luma = picture[:, :, :3].astype(np.float64) @ _LUMA
        gradient = np.abs(np.diff(luma, axis=0)).mean() + np.abs(np.diff(luma, axis=1)).mean()
        labels = self._labels(place)
        things, dark = (labels >= 0) & (labels != self._ground), luma < DARK
        beside, near, far = (
            binary_dilation(things, np.ones((3, 3)), iterations=count)
            for count in (3 * self._reach // 4, 3 * self._reach // 2, 4 * self._reach)
        )
        return Looks(gradient, dark[beside & ~things].mean(), dark[far & ~near].mean())

    def _labels(self, place):
        camera = self.geometry.orbit.at(place)
        return positions_of_mesh(self.geometry.mesh, camera, self.geometry.size).labels

    def _motion(self, place, other):
        cameras = [self.geometry.orbit.at(each) for each in (place, other)]
        matrices = [camera.matrix(self.geometry.size) for camera in cameras]
        _, inverse = look_at_mesh(self.geometry.mesh, cameras[0], self.geometry.size)
        return motion_by_depth(inverse, transfer_of(*matrices)[None])[0]


class WithoutSilhouettes(NamedTuple):
    """A mesh as the thesis masks it: strokes beside a silhouette belong to what they lie on.

    Attributes
    ----------
    geometry : MeshGeometry
    """

    geometry: MeshGeometry

    def view_labels(self):
        """As :class:`~stylit_ref.views.interpolation.surface.Geometry`."""
        mesh, orbit, size = self.geometry.mesh, self.geometry.orbit, self.geometry.size
        return np.stack([positions_of_mesh(mesh, camera, size).labels for camera in orbit.cameras])

    def look(self, place, views):
        """As :class:`~stylit_ref.views.interpolation.surface.Geometry`."""
        surface, motion = self.geometry.look(place, views)
        height, width = surface.labels.shape
        own = np.stack(np.mgrid[:height, :width], axis=-1).astype(np.int32)
        return Surface(surface.labels, own), motion
