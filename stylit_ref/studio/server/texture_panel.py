"""A texture of an exemplar, on which patches are dragged and dropped."""

from pathlib import Path
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from stylit_ref.files.read_image import read_uint8
from stylit_ref.studio.server.body import json_body, points
from stylit_ref.studio.server.in_thread import in_thread
from stylit_ref.studio.server.painters import refuse_readers
from stylit_ref.studio.server.panel import Panel
from stylit_ref.studio.server.png import png_response
from stylit_ref.studio.server.texture_process import TextureProcess


class Texture(Protocol):
    """What the panel shows, in this process or in another."""

    @property
    def exemplar(self) -> NDArray[np.uint8]:
        """What the texture looks like, (H, W, 3) uint8."""
        ...

    def picture(self) -> NDArray[np.uint8]:
        """The texture as it is now, (H, W, 3) uint8."""
        ...

    def dropped(
        self, source: tuple[int, int], place: tuple[int, int], *, keep: bool
    ) -> NDArray[np.uint8]:
        """The texture with a patch on it, which stays there if it is kept."""
        ...

    def close(self) -> None:
        """Give up what is being made."""
        ...


def read_texture(file: str | Path) -> Texture:
    """A texture of an exemplar's file.

    Raises
    ------
    InputError
        If it cannot be read.
    """
    image = read_uint8(file)
    colours = image if image.shape[2] in (1, 3) else image[:, :, :-1]
    return TextureProcess(np.ascontiguousarray(np.broadcast_to(colours, (*image.shape[:2], 3))))


def texture_panel(texture: Texture) -> Panel:
    """``/texture/exemplar``, ``/texture/picture`` and ``/texture/drop``."""

    async def shown(request: Request) -> Response:
        return png_response(texture.exemplar)

    async def picture(request: Request) -> Response:
        return await in_thread(lambda: png_response(texture.picture()))

    async def dropped(request: Request) -> Response:
        refuse_readers(request)
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
        texture.close,
    )
