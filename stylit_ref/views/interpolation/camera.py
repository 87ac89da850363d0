"""Pinhole cameras: any place, direction, field of view, lens shift and pixel aspect."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError

_LENGTHS = {"origin": 3, "target": 3, "up": 3, "shift": 2}
_NEEDED = "origin", "target", "field_of_view"
_KNOWN = *_NEEDED, "up", "shift", "pixel_aspect"


@dataclass(frozen=True)
class Camera:
    """Where an eye is, and what it sees.

    Attributes
    ----------
    origin, target : tuple of 3 float
        The eye, and what it looks at, in the units of the scene.
    field_of_view : float
        Vertical, in degrees; more than 0 and less than 180.
    up : tuple of 3 float
        The direction that is up in the scene.
    shift : tuple of 2 float
        Lens shift to the right and upwards, in heights of the picture.
    pixel_aspect : float
        How wide a pixel is for its height.
    """

    origin: tuple[float, float, float]
    target: tuple[float, float, float]
    field_of_view: float
    up: tuple[float, float, float] = (0.0, 1.0, 0.0)
    shift: tuple[float, float] = (0.0, 0.0)
    pixel_aspect: float = 1.0

    def matrix(self, size: tuple[int, int]) -> NDArray[np.float64]:
        """The matrix M of :mod:`stylit_ref.views.interpolation.formulae.transfer`.

        Parameters
        ----------
        size : tuple of 2 int
            Rows and columns of the picture.

        Returns
        -------
        (3, 4) float64
        """
        height, width = size
        right, up, forward = self.axes()
        focal = height / (2 * np.tan(np.radians(self.field_of_view) / 2))
        middle_x = (width - 1) / 2 - self.shift[0] * height / self.pixel_aspect
        middle_y = (height - 1) / 2 + self.shift[1] * height
        rows = np.array(
            [
                focal / self.pixel_aspect * right + middle_x * forward,
                -focal * up + middle_y * forward,
                forward,
            ]
        )
        return np.column_stack([rows, -rows @ np.array(self.origin)])

    def axes(self) -> NDArray[np.float64]:
        """Unit vectors to the right, up and forward, as rows of (3, 3) float64."""
        forward = _unit(np.subtract(self.target, self.origin))
        right = _unit(np.cross(forward, self.up))
        return np.array([right, np.cross(right, forward), forward])


def read_camera(facts: Mapping[str, Any] | None, name: str) -> Camera:
    """The camera that an object of a manifest describes.

    Parameters
    ----------
    facts : mapping or None
        With ``origin``, ``target``, ``field_of_view``, and perhaps ``up``, ``shift`` and
        ``pixel_aspect``; other entries are passed over.
    name : str
        Of the view, for messages.

    Raises
    ------
    InputError
        If something is missing, no number, or describes no camera.
    """
    if facts is None or facts == {}:
        raise InputError(
            f"there is no camera of {name}; the views between others need {', '.join(_NEEDED)} of "
            "each camera"
        )
    if not isinstance(facts, Mapping):
        raise InputError(
            f"the camera of {name} is {facts!r}; it must be an object with {', '.join(_NEEDED)}"
        )
    values = {}
    for key in _KNOWN:
        if key in facts:
            values[key] = _read(facts[key], _LENGTHS.get(key), f"{key} of the camera of {name}")
        elif key in _NEEDED:
            others = [other for other in facts if other not in _KNOWN]
            has = f", and has {others[0]!r}" if others else ""
            raise InputError(
                f"the camera of {name} lacks {key!r}{has}; the views between others need "
                f"{', '.join(_NEEDED)} of each camera"
            )
    camera = Camera(**values)
    if not 0 < camera.field_of_view < 180:
        raise InputError(
            f"field_of_view of the camera of {name} is {camera.field_of_view:g}; it must be more "
            "than 0 and less than 180 degrees"
        )
    if not camera.pixel_aspect > 0:
        raise InputError(
            f"pixel_aspect of the camera of {name} is {camera.pixel_aspect:g}; it must be more "
            "than 0"
        )
    with np.errstate(invalid="ignore", divide="ignore"):
        if not np.isfinite(camera.axes()).all():
            raise InputError(
                f"the camera of {name} looks nowhere, or along its up; origin and target must "
                "differ, and not by a multiple of up alone"
            )
    return camera


def _read(value: Any, length: int | None, what: str) -> Any:
    """A finite number, or a tuple of some."""
    numbers = [value] if length is None else value
    is_fit = isinstance(numbers, list | tuple) and len(numbers) == (length or 1)
    if not is_fit or not all(
        isinstance(number, int | float) and not isinstance(number, bool) and isfinite(number)
        for number in numbers
    ):
        wanted = "a finite number" if length is None else f"{length} finite numbers"
        raise InputError(f"{what} is {value!r}; it must be {wanted}")
    return float(value) if length is None else tuple(map(float, value))


def _unit(vector: NDArray[np.float64]) -> NDArray[np.float64]:
    return vector / np.linalg.norm(vector)
