"""Pinhole cameras, so that what the renderer sees can be computed without it."""

from typing import NamedTuple

import numpy as np


class Camera(NamedTuple):
    """Where the eye is, what it looks at (both in the units of the stage), how much it sees.

    Attributes
    ----------
    origin, target : 3 floats
        The y axis is up.
    field_of_view : float
        Vertical, in degrees.
    """

    origin: tuple
    target: tuple
    field_of_view: float

    def axes(self):
        """Unit vectors right, up, forward as rows."""
        forward = np.subtract(self.target, self.origin)
        forward = forward / np.linalg.norm(forward)
        right = np.cross(forward, (0, 1, 0))
        right /= np.linalg.norm(right)
        return np.array([right, np.cross(right, forward), forward])

    def directions(self, height, width):
        """Unit directions through the pixel centres, (H, W, 3)."""
        x = (2 * np.arange(width) + 1 - width) / height
        y = (height - 1 - 2 * np.arange(height)) / height
        local = np.stack(np.broadcast_arrays(x, y[:, None], 1 / self._slope), axis=-1)
        directions = local @ self.axes()
        return directions / np.linalg.norm(directions, axis=-1, keepdims=True)

    def project(self, points, height, width):
        """Where points appear.

        Parameters
        ----------
        points : (..., 3) float

        Returns
        -------
        (..., 2) float64
            (y, x) in pixels, whole at pixel centres; NaN behind the camera.
        """
        local = (points - np.asarray(self.origin)) @ self.axes().T
        with np.errstate(divide="ignore", invalid="ignore"):
            across = local[..., :2] / local[..., 2:] / self._slope
        across[local[..., 2] <= 0] = np.nan
        x = (across[..., 0] * height + width - 1) / 2
        y = (height - 1 - across[..., 1] * height) / 2
        return np.stack([y, x], axis=-1)

    @property
    def _slope(self):
        return np.tan(np.radians(self.field_of_view) / 2)


class Orbit(NamedTuple):
    """Cameras on a sphere, all of which look at its middle.

    Attributes
    ----------
    middle : 3 floats
    distance : float
        Of the cameras, in the units of the stage.
    field_of_view : float
        Vertical, in degrees.
    """

    middle: tuple
    distance: float
    field_of_view: float

    def at(self, azimuth, elevation):
        """The camera at two angles in degrees; azimuth 0 looks at the front, 90 from the right."""
        a, e = np.radians(azimuth), np.radians(elevation)
        middle = np.array(self.middle)
        away = np.array([np.sin(a) * np.cos(e), np.sin(e), np.cos(a) * np.cos(e)])
        origin = middle + self.distance * away
        return Camera(tuple(origin.tolist()), tuple(middle.tolist()), self.field_of_view)

    def grid(self, azimuths, elevations):
        """Cameras by (row, column): a row for each elevation, a column for each azimuth."""
        return {
            (row, column): self.at(azimuth, elevation)
            for row, elevation in enumerate(elevations)
            for column, azimuth in enumerate(azimuths)
        }


STAGE_VIEW = Camera(origin=(0.0, 2.75, 9.0), target=(0.0, 1.22, 0.0), field_of_view=25.0)
"""The one view of the source and of all targets."""

_AWAY = np.subtract(STAGE_VIEW.origin, STAGE_VIEW.target)

STAGE = Orbit(STAGE_VIEW.target, np.linalg.norm(_AWAY), STAGE_VIEW.field_of_view)
STAGE_ELEVATION = np.degrees(np.arctan2(_AWAY[1], _AWAY[2]))
"""Of ``STAGE_VIEW``, whose azimuth is 0."""

HOUSE = Orbit((0.1, 2.8, 0.3), 19.5, 28.0)
SOURCE_AZIMUTH, SOURCE_ELEVATION = 5, 10

HOUSE_SOURCE = HOUSE.at(SOURCE_AZIMUTH, SOURCE_ELEVATION)
"""The view of the house that an artist would paint over."""

GRID = HOUSE.grid((20, 25, 30), (8, 13, 18))
"""The house's views by row and column: neighbours are 5° apart on a sphere around it."""

CHAPEL = Orbit((-0.8, 3.2, 0.3), 22.5, 28.0)
"""Around the chapel; its source has the angles of the house's."""
