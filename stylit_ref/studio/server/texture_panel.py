"""A texture of an exemplar, on which patches are dragged and dropped."""

from pathlib import Path
from threading import Lock

import numpy as np
from numpy.typing import NDArray
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from stylit_ref.files.read_image import read_uint8
from stylit_ref.studio.server.body import json_body, points
from stylit_ref.studio.server.in_thread import in_thread
from stylit_ref.studio.server.panel import Panel
from stylit_ref.studio.server.png import png_response
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
        self._turn = Lock()

    @property
    def picture(self) -> NDArray[np.uint8]:
        """The texture as it is now, (side, side, 3) uint8."""
        with self._turn:
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
        with self._turn:
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


def read_texture(file: str | Path) -> DroppedTexture:
    """A texture of an exemplar's file.

    Raises
    ------
    InputError
        If it cannot be read.
    """
    image = read_uint8(file)
    colours = image if image.shape[2] in (1, 3) else image[:, :, :-1]
    return DroppedTexture(np.ascontiguousarray(np.broadcast_to(colours, (*image.shape[:2], 3))))


def texture_panel(texture: DroppedTexture) -> Panel:
    """``/texture/exemplar``, ``/texture/picture`` and ``/texture/drop``."""

    async def shown(request: Request) -> Response:
        return png_response(texture.exemplar)

    async def picture(request: Request) -> Response:
        return await in_thread(lambda: png_response(texture.picture))

    async def dropped(request: Request) -> Response:
        said = await json_body(request)
        source, place = (
            tuple(map(int, points({name: [said.get(name)]}, name, 1)[0])) for name in ("from", "to")
        )
        keep = said.get("keep")
        if not isinstance(keep, bool):
            raise HTTPException(400, "The request needs keep: true or false.")
        return await in_thread(lambda: png_response(texture.dropped(source, place, keep=keep)))

    return Panel(
        "texture",
        [
            Route("/texture/exemplar", shown),
            Route("/texture/picture", picture),
            Route("/texture/drop", dropped, methods=["POST"]),
        ],
    )
