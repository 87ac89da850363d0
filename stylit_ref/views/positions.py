"""Where in the scene the points lie that a view shows, in place of a mesh."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Positions(NamedTuple):
    """A pass of positions.

    Attributes
    ----------
    points : (H, W, 3) float32
        In the units of the cameras; they mean nothing where nothing is.
    labels : (H, W) int32
        The face, or the object, of every pixel: strokes are not shifted from one to another. -1
        where nothing is.
    """

    points: NDArray[np.float32]
    labels: NDArray[np.int32]
