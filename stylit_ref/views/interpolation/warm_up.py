"""Which kernels views between others need."""

import numpy as np

from stylit_ref.machine.compilation import Specialization
from stylit_ref.machine.kernel import rehearsal
from stylit_ref.views.frames import Motion, grid_pairs
from stylit_ref.views.interpolation.camera import Camera
from stylit_ref.views.interpolation.fields_geometry import FieldsGeometry
from stylit_ref.views.interpolation.mesh_geometry import MeshGeometry
from stylit_ref.views.interpolation.orbit import Orbit, orbit_of
from stylit_ref.views.interpolation.positions_geometry import PositionsGeometry
from stylit_ref.views.interpolation.surface import Geometry, GeometryKind
from stylit_ref.views.interpolation.view_interpolator import (
    MODES,
    Stylized,
    ViewInterpolator,
)
from stylit_ref.views.mesh import make_mesh

_SIZE = 4, 4


def kernels_of_views(
    style_channels: int, patch_width: int, geometry: GeometryKind = "mesh"
) -> list[Specialization]:
    """The kernels that pictures between views call, in any mode.

    They are found out by small pictures in which they do nothing, as by
    :func:`stylit_ref.stylization.warm_up.kernels_of_run`.

    Parameters
    ----------
    style_channels, patch_width : int
    geometry : {"mesh", "positions", "fields"}, optional
        What the motion comes from.

    Returns
    -------
    list of Specialization
        In the order of their first calls.
    """
    cameras = [Camera((x, y, 5.0), (0.0, 0.0, 0.0), 40.0) for y in (-1.0, 1.0) for x in (-1.0, 1.0)]
    orbit, side = orbit_of(cameras, 2, 2), 2 * patch_width
    count = len(cameras)
    stylized = Stylized(
        np.zeros((side, side, style_channels), np.uint8),
        patch_width,
        np.zeros((count, *_SIZE), np.int32),
        np.zeros((count, *_SIZE, style_channels), np.uint8),
    )
    with rehearsal() as rehearsed:
        views = ViewInterpolator(orbit.grid, _geometry(orbit, geometry), stylized)
        for mode in MODES:
            views.picture((0.0, 0.0), mode)
    return list(rehearsed)


def _geometry(orbit: Orbit, kind: GeometryKind) -> Geometry:
    if kind == "fields":
        still = Motion(np.zeros((*_SIZE, 2), np.float32), np.ones(_SIZE, np.bool_))
        return FieldsGeometry(dict.fromkeys(grid_pairs(2, 2), still), orbit.grid, _SIZE)
    if kind == "mesh":
        return MeshGeometry(make_mesh(np.eye(3), np.array([[0, 1, 2]])), orbit, _SIZE)
    count = len(orbit.cameras)
    points = np.zeros((count, *_SIZE, 3), np.float32)
    return PositionsGeometry(points, np.zeros((count, *_SIZE), np.int32), orbit)
