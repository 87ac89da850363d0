"""Whether positions belong to their cameras: each must be seen at the pixel that holds it."""

import numpy as np

from stylit_ref.errors import InputError
from stylit_ref.views.interpolation.camera import Camera
from stylit_ref.views.positions import Positions

MOST_APART = 1.0
"""Positions belong to a camera that sees them less far from their pixels, in pixels."""

_SAMPLE = 64
"""Rows, and columns, of the pixels that are looked at."""


def check_positions(
    positions: Positions, camera: Camera | None, size: tuple[int, int], name: str
) -> None:
    """Refuse positions of another size, or that their camera sees elsewhere.

    Parameters
    ----------
    positions : Positions
    camera : Camera or None
        None where it is not known.
    size : tuple of 2 int
        Rows and columns of the views.
    name : str
        Of the view, for messages.

    Raises
    ------
    InputError
    """
    height, width = positions.labels.shape
    if (height, width) != size or positions.points.shape != (*size, 3):
        raise InputError(
            f"the positions of {name} are {width}x{height}, and its views are {size[1]}x{size[0]}; "
            "render both at one size"
        )
    apart = None if camera is None else _median_apart(positions, camera)
    if apart is not None and not apart < MOST_APART:
        far = f"{apart:.1f} pixels away from" if np.isfinite(apart) else "nowhere near"
        raise InputError(
            f"the camera of {name} sees the points of its positions {far} the pixels that hold "
            "them; export both from one scene, in the same units and with the same axes"
        )


def _median_apart(positions: Positions, camera: Camera) -> float | None:
    """Of a sample; infinite if most lie behind the camera, None if the view shows nothing."""
    size = positions.labels.shape
    y, x = np.meshgrid(*(np.arange(0, side, -(-side // _SAMPLE)) for side in size), indexing="ij")
    shown = positions.labels[y, x] >= 0
    y, x = y[shown], x[shown]
    if not y.size:
        return None
    matrix = camera.matrix(size)
    points = positions.points[y, x].astype(np.float64)
    across, down, depth = matrix[:, :3] @ points.T + matrix[:, 3:]
    in_front = np.where(depth > 0, depth, np.nan)
    apart = np.hypot(across / in_front - x, down / in_front - y)
    return float(np.median(np.where(np.isnan(apart), np.inf, apart)))
