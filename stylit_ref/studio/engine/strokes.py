"""Paint that waits for the thread of the engine, as while kernels are compiled."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.studio.engine.follower import Follower

_MOST = 2
"""Paintings that may wait as rectangles, by their bytes."""


class Strokes:
    """Rectangles in their order; once they are too many, the painting itself in their place."""

    def __init__(self) -> None:
        self._rectangles: list[tuple[int, int, NDArray[np.uint8], int]] = []
        self._bytes = 0

    def add(
        self, x: int, y: int, pixels: NDArray[np.uint8], serial: int, painting: NDArray[np.uint8]
    ) -> None:
        """Let one more wait.

        Parameters
        ----------
        x, y : int
            Its left upper pixel.
        pixels : (h, w, 3) uint8
        serial : int
        painting : (H_A, W_A, 3) uint8
            With the rectangle in it.
        """
        self._rectangles.append((x, y, pixels, serial))
        self._bytes += pixels.nbytes
        if self._bytes > _MOST * painting.nbytes:
            self._rectangles = [(0, 0, painting.copy(), serial)]
            self._bytes = painting.nbytes

    def onto(self, follower: Follower) -> None:
        """Paint them."""
        for x, y, pixels, serial in self._rectangles:
            follower.paint(x, y, pixels, serial)
