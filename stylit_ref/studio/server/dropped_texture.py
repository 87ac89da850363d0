"""A texture of an exemplar, and patches of it that are dropped there."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.texture.dragging import drag, drop
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession

SIDE = 256
"""Height and width of the texture in pixels."""

ITERATIONS = 12


class DroppedTexture:
    """A texture, synthesized when somebody asks for it.

    Parameters
    ----------
    exemplar : (H, W, 3) uint8
    side, iterations : int

    Attributes
    ----------
    exemplar : (H, W, 3) uint8
    """

    def __init__(
        self, exemplar: NDArray[np.uint8], *, side: int = SIDE, iterations: int = ITERATIONS
    ) -> None:
        self.exemplar: NDArray[np.uint8] = exemplar
        self._side, self._iterations = side, iterations
        self._made: TextureSession | None = None

    def picture(self) -> NDArray[np.uint8]:
        """The texture as it is now, (side, side, 3) uint8."""
        return self._session().image

    def dropped(
        self, source: tuple[int, int], place: tuple[int, int], *, keep: bool
    ) -> NDArray[np.uint8]:
        """The texture with a patch on it.

        Parameters
        ----------
        source, place : tuple of int
            x and y of the patch's middle: in the exemplar, and in the texture.
        keep : bool
            Whether it stays there.

        Raises
        ------
        InputError
            If a place is none, or too close to the exemplar's border.
        """
        session = self._session()
        patch = drag(session, (1, *source[::-1]), place[::-1])
        if keep:
            drop(session, patch)
            return session.image
        picture = session.image
        middle = patch.covers.shape[0] // 2
        y, x = np.nonzero(patch.covers)
        rows, columns = (y + patch.y - middle) % self._side, (x + patch.x - middle) % self._side
        picture[rows, columns] = patch.colours[y, x]
        return picture

    def close(self) -> None:
        """There is nothing to give up."""

    def _session(self):
        if self._made is None:
            fits = 2 * ((min(*self.exemplar.shape[:2], self._side) + 1) // 2) - 1
            radius = min(TextureParams().radius, fits)
            params = TextureParams(radius=radius, radius_end=radius)
            session = TextureSession([self.exemplar], (self._side, self._side), params)
            for _ in range(self._iterations):
                session.step()
            self._made = session
        return self._made
