"""Thumbnails of the layers that a scene may be made of."""

from functools import lru_cache

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from stylit_ref.errors import InputError
from stylit_ref.studio.scene_files.shelf import Shelf
from stylit_ref.studio.server.png import THUMBNAIL, png_response
from stylit_ref.studio.server.protocol import sentence

_MOST = 512
"""Thumbnails that are kept."""


def thumbnail_route(shelf: Shelf) -> Route:
    """``/thumb/SCENE/SIDE/LAYER``: names of a shelf, of which none is a path.

    Parameters
    ----------
    shelf : Shelf
    """

    @lru_cache(_MOST)
    def thumbnail(scene: str, side: str, layer: str) -> Response:
        offer = shelf.offer(scene)
        if side not in ("A", "B"):
            raise InputError("a scene has sides A and B")
        opened = offer.read([layer])
        buffers = opened.source if side == "A" else opened.target(0)
        return png_response(next(iter(buffers.values())), most=THUMBNAIL)

    def answer(request: Request) -> Response:
        asked = request.path_params
        try:
            return thumbnail(asked["scene"], asked["side"], asked["layer"])
        except InputError as error:
            raise HTTPException(404, sentence(error)) from None

    return Route("/thumb/{scene}/{side}/{layer:path}", answer)
