"""A grid of views that a page is made of, wherever it comes from."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.notes import note
from stylit_ref.views.interpolation.grid import Grid
from stylit_ref.views.interpolation.orbit import Orbit
from stylit_ref.views.mesh import Mesh
from stylit_ref.views.positions import Positions


@dataclass(frozen=True, eq=False)
class GridViews:
    """Views, and what is known of them.

    Attributes
    ----------
    grid : Grid
    size : tuple of 2 int
        Rows and columns of every view.
    style : (H_A, W_A, 3) uint8 or None
        None if there are pictures alone.
    patch_width : int
    view : callable
        By the number of a frame its NNF, (H, W, 2) int32, or its picture, (H, W, 3) uint8, if there
        is no style.
    orbit : Orbit or None
        None where cameras are not known.
    mesh : Mesh or None
        What the views show.
    points : callable, optional
        In place of a mesh, by the number of a frame the positions of what it shows. Without either,
        or without cameras, views can only be blended.
    """

    grid: Grid
    size: tuple[int, int]
    style: NDArray[np.uint8] | None
    patch_width: int
    view: Callable[[int], NDArray[np.int32] | NDArray[np.uint8]]
    orbit: Orbit | None = None
    mesh: Mesh | None = None
    points: Callable[[int], Positions] | None = None


def opaque(image: NDArray[np.uint8], name: str) -> NDArray[np.uint8]:
    """An image as red, green and blue; on white where it is transparent.

    Parameters
    ----------
    image : (H, W, n) uint8
        Grey or colours, perhaps with alpha.
    name : str
        Of what it belongs to, for messages.

    Returns
    -------
    (H, W, 3) uint8

    Raises
    ------
    InputError
        If it has more than four channels.
    """
    channels = image.shape[2]
    if channels > 4:
        raise InputError(f"{name}: has {channels} channels; at most 4 can be shown")
    colours = image if channels in (1, 3) else image[:, :, :-1]
    if channels in (2, 4):
        note(f"{name}: is transparent in places, and the page shows it on white")
        alpha = image[:, :, -1:].astype(np.uint32)
        colours = ((colours * alpha + 255 * (255 - alpha) + 127) // 255).astype(np.uint8)
    return np.ascontiguousarray(np.broadcast_to(colours, (*image.shape[:2], 3)))
