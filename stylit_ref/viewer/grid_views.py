"""A grid of views that a page is made of, wherever it comes from."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stylit_ref.views.interpolation.grid import Grid
from stylit_ref.views.interpolation.orbit import Orbit
from stylit_ref.views.mesh import Mesh


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
        What the views show. Without it, or without cameras, views can only be blended.
    """

    grid: Grid
    size: tuple[int, int]
    style: NDArray[np.uint8] | None
    patch_width: int
    view: Callable[[int], NDArray[np.int32] | NDArray[np.uint8]]
    orbit: Orbit | None = None
    mesh: Mesh | None = None
