"""Cameras around a scene: where they stand in degrees, and those between them."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from stylit_ref.views.interpolation.axis import Axis, closes_ring, steps_axis
from stylit_ref.views.interpolation.camera import Camera
from stylit_ref.views.interpolation.formulae.transfer import transfer_of
from stylit_ref.views.interpolation.grid import Grid, bilinear

_FRONTS = (0.0, 0.0, 1.0), (0.0, -1.0, 0.0)
"""Where azimuth 0 is: in front of scenes whose y is up, and of those whose z is."""


@dataclass(frozen=True)
class Orbit:
    """The cameras of a grid, and those between them.

    Attributes
    ----------
    grid : Grid
        In degrees around what the cameras look at; in steps if they do not turn around it.
    cameras : tuple of Camera
        Of every frame.
    """

    grid: Grid
    cameras: tuple[Camera, ...]

    def at(self, place: tuple[float, float]) -> Camera:
        """The camera at a place of the grid.

        Between cameras that look at one point from equally far it does so too. Whatever else
        differs between the cameras is blended.

        Parameters
        ----------
        place : tuple of 2 float
            To the right and upwards, from the middle of the grid.
        """
        between = self.grid.between(place)
        mean = bilinear(self._facts, between)
        target, up = mean[0:3], mean[3:6]
        if self.grid.columns.unit == "degrees":
            turn, rise = between[0].at + mean[9], between[1].at + mean[10]
            origin = target + mean[11] * _direction(turn, rise, up)
        else:
            origin = mean[12:15]
        return Camera(
            tuple(origin.tolist()), tuple(target.tolist()), float(mean[8]), tuple(up.tolist()),
            tuple(mean[6:8].tolist()), float(mean[15]),
        )  # fmt: skip

    def transfers(
        self, matrix: NDArray[np.float64], views: Sequence[int], size: tuple[int, ...]
    ) -> NDArray[np.float64]:
        """How pixels of a camera go over into those of some views.

        Parameters
        ----------
        matrix : (3, 4) float64
            Of the camera.
        views : sequence of K int
        size : tuple of 2 int
            Rows and columns.

        Returns
        -------
        (K, ...) float64
            As of :func:`~stylit_ref.views.interpolation.formulae.transfer.transfer_of`.
        """
        others = [self.cameras[view].matrix(size) for view in views]
        return np.stack([transfer_of(matrix, other) for other in others])

    @cached_property
    def _facts(self) -> NDArray[np.float64]:
        """What is blended of each camera, (rows, columns, 16)."""
        facts = []
        for row, frames in enumerate(self.grid.frames):
            for column, frame in enumerate(frames):
                camera = self.cameras[frame]
                azimuth, elevation, distance = angles_of(camera)
                off = azimuth - self.grid.columns.positions[column]
                facts.append([
                    *camera.target, *camera.up, *camera.shift, camera.field_of_view,
                    (off + 180) % 360 - 180, elevation - self.grid.rows.positions[row], distance,
                    *camera.origin, camera.pixel_aspect,
                ])  # fmt: skip
        return np.array(facts).reshape(len(self.grid.frames), -1, 16)


def orbit_of(cameras: Sequence[Camera], rows: int, columns: int) -> Orbit:
    """The orbit of cameras that are given row by row.

    Columns stand where their cameras are on average, and so do rows.

    Parameters
    ----------
    cameras : sequence of Camera
    rows, columns : int

    Returns
    -------
    Orbit
    """
    frames = np.arange(rows * columns).reshape(rows, columns)
    angles = np.array([angles_of(camera)[:2] for camera in cameras]).reshape(rows, columns, 2)
    across = np.unwrap(np.unwrap(angles[..., 0], axis=0, period=360), axis=1, period=360).mean(0)
    upwards = angles[..., 1].mean(1)
    if len(across) > 1 and across[0] > across[1]:
        across, frames = across[::-1], frames[:, ::-1]
    if len(upwards) > 1 and upwards[0] > upwards[1]:
        upwards, frames = upwards[::-1], frames[::-1]
    across, upwards = across.round(_DECIMALS), upwards.round(_DECIMALS)
    numbers = tuple(map(tuple, frames.tolist()))
    if (np.diff(across) > _LEAST_TURN).all() and (np.diff(upwards) > _LEAST_TURN).all():
        azimuths = tuple(across.tolist())
        grid = Grid(
            Axis(azimuths, is_ring=closes_ring(azimuths)), Axis(tuple(upwards.tolist())), numbers
        )
    else:
        grid = grid_of_steps(rows, columns)
    return Orbit(grid, tuple(cameras))


_DECIMALS = 9
"""Of positions: cameras that were placed at whole degrees stand at whole degrees."""

_LEAST_TURN = 1e-3
"""Cameras that are less than that apart, in degrees, do not turn."""


def grid_of_steps(rows: int, columns: int) -> Grid:
    """A grid whose places count views: the first row is the lowest."""
    frames = np.arange(rows * columns).reshape(rows, columns)
    return Grid(steps_axis(columns), steps_axis(rows), tuple(map(tuple, frames.tolist())))


def angles_of(camera: Camera) -> tuple[float, float, float]:
    """Azimuth and elevation of a camera, in degrees, and how far it is from its target.

    Azimuth grows as the camera moves to the right. It is 0 in front: towards z where y is up, and
    against y where z is up.
    """
    up, side, front = _basis(np.array(camera.up))
    away = np.subtract(camera.origin, camera.target)
    distance = np.linalg.norm(away)
    azimuth = np.degrees(np.arctan2(away @ side, away @ front))
    elevation = np.degrees(np.arcsin(np.clip(away @ up / distance, -1, 1)))
    return float(azimuth), float(elevation), float(distance)


def _direction(azimuth, elevation, up):
    """From the target to the camera."""
    up, side, front = _basis(up)
    a, e = np.radians(azimuth), np.radians(elevation)
    return np.sin(a) * np.cos(e) * side + np.sin(e) * up + np.cos(a) * np.cos(e) * front


def _basis(up):
    up = up / np.linalg.norm(up)
    front = min((np.array(front) for front in _FRONTS), key=lambda front: abs(front @ up))
    front = front - (front @ up) * up
    front = front / np.linalg.norm(front)
    return up, np.cross(up, front), front
