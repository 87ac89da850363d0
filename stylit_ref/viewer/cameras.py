"""Cameras and axes of a grid as a page holds them."""

from typing import Any

from stylit_ref.views.interpolation.axis import Axis
from stylit_ref.views.interpolation.camera import Camera
from stylit_ref.views.interpolation.orbit import Orbit, angles_of


def axis_facts(axis: Axis) -> dict[str, Any]:
    """Where the rows or columns of a grid stand."""
    return {"positions": list(axis.positions), "unit": axis.unit, "isRing": axis.is_ring}


def camera_facts(orbit: Orbit, row: int, column: int) -> dict[str, Any]:
    """A camera of a grid, and how far it stands from its row and column."""
    camera: Camera = orbit.cameras[orbit.grid.frames[row][column]]
    azimuth, elevation, distance = angles_of(camera)
    return {
        "origin": camera.origin,
        "target": camera.target,
        "up": camera.up,
        "fieldOfView": camera.field_of_view,
        "shift": camera.shift,
        "pixelAspect": camera.pixel_aspect,
        "turn": (azimuth - orbit.grid.columns.positions[column] + 180) % 360 - 180,
        "rise": elevation - orbit.grid.rows.positions[row],
        "distance": distance,
    }
