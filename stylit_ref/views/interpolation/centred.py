"""Scenes far from where their coordinates are 0, as maps and cities are."""

from dataclasses import replace

import numpy as np

from stylit_ref.views.interpolation.camera import Camera
from stylit_ref.views.interpolation.orbit import Orbit
from stylit_ref.views.mesh import Mesh


def centred(mesh: Mesh, orbit: Orbit) -> tuple[Mesh, Orbit]:
    """A mesh and its cameras, moved together so that 32 bits hold the vertices.

    Parameters
    ----------
    mesh : Mesh
    orbit : Orbit

    Returns
    -------
    mesh : Mesh
        Of float32 vertices, around 0 if it was one of float64; otherwise as it is.
    orbit : Orbit
    """
    if mesh.vertices.dtype == np.float32:
        return mesh, orbit
    middle = (mesh.vertices.min(axis=0) + mesh.vertices.max(axis=0)) / 2
    vertices = (mesh.vertices - middle).astype(np.float32)
    cameras = tuple(_moved(camera, middle) for camera in orbit.cameras)
    return mesh._replace(vertices=vertices), replace(orbit, cameras=cameras)


def _moved(camera: Camera, middle) -> Camera:
    origin, target = (tuple((each - middle).tolist()) for each in (camera.origin, camera.target))
    return replace(camera, origin=origin, target=target)
