"""The application: what there is at which address."""

from collections.abc import Sequence
from importlib.resources import files

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import BaseRoute, Route, WebSocketRoute
from starlette.types import ASGIApp
from starlette.websockets import WebSocket

from stylit_ref.studio.server.access import Access
from stylit_ref.studio.server.beginning import Beginning
from stylit_ref.studio.server.desk import Desk
from stylit_ref.studio.server.exported import export_route
from stylit_ref.studio.server.guard import Guard
from stylit_ref.studio.server.live_socket import live
from stylit_ref.studio.server.panel import Panel
from stylit_ref.studio.server.protocol import LARGEST_MESSAGE
from stylit_ref.studio.server.thumbnails import thumbnail_route

_PAGE = {
    "/": ("page.html", "text/html"),
    "/studio.js": ("bundle/studio.js", "text/javascript"),
    "/studio.css": ("page.css", "text/css"),
}

_SENTENCES = {
    404: "There is nothing at this address of the studio.",
    405: "This address of the studio is not asked in this way.",
    413: "That is more than 64 MB.",
}


def make_app(
    access: Access, desk: Desk, beginning: Beginning, panels: Sequence[Panel] = ()
) -> ASGIApp:
    """The application, guarded.

    Parameters
    ----------
    access : Access
    desk : Desk
        Panels find it in the application's state.
    beginning : Beginning
    panels : sequence of Panel
    """

    async def socket(socket: WebSocket) -> None:
        await live(socket, desk)

    routes: list[BaseRoute] = [
        *(_part_of_page(path, name, kind) for path, (name, kind) in _PAGE.items()),
        Route("/favicon.ico", _nothing),
        WebSocketRoute("/live", socket),
        thumbnail_route(beginning.shelf),
        export_route(beginning.folder),
        *(route for panel in panels for route in panel.routes),
    ]
    app = Starlette(
        routes=routes,
        exception_handlers={HTTPException: _sentence},
        max_body_size=LARGEST_MESSAGE,
    )
    app.state.desk = desk
    app.router.redirect_slashes = False
    return Guard(app, access)


def _part_of_page(path: str, name: str, kind: str) -> Route:
    content = files("stylit_ref.studio").joinpath(name).read_bytes()

    async def answer(request: Request) -> Response:
        return Response(content, media_type=kind)

    return Route(path, answer)


async def _nothing(request: Request) -> Response:
    return Response(status_code=204)


async def _sentence(request: Request, error: Exception) -> Response:
    """Why not, in one sentence."""
    assert isinstance(error, HTTPException)
    text = _SENTENCES.get(error.status_code, "")
    is_own = error.detail.endswith(".")
    return PlainTextResponse((error.detail if is_own else text) + "\n", error.status_code)
