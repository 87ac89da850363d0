"""The viewer's page of finished views, in a frame of its own."""

from collections.abc import Callable
from functools import cache

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from stylit_ref.errors import InputError
from stylit_ref.studio.server.panel import Panel
from stylit_ref.studio.server.protocol import sentence

_POLICY = (
    "sandbox allow-scripts allow-downloads; default-src 'none'; script-src 'unsafe-inline'; "
    "style-src 'unsafe-inline'; img-src blob: data:; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'self'"
)
"""Its program is within it. In a sandbox that can ask the studio for nothing."""


def views_panel(page: Callable[[], bytes]) -> Panel:
    """``/views/``.

    Parameters
    ----------
    page : callable
        Makes the page, in windows-1252; is called when somebody asks for it.
    """
    page = cache(page)

    def answer(request: Request) -> Response:
        try:
            content = page()
        except InputError as error:
            raise HTTPException(404, sentence(error)) from None
        kind = "text/html; charset=windows-1252"
        return Response(content, headers={"Content-Security-Policy": _POLICY}, media_type=kind)

    return Panel("views", [Route("/views/", answer)])
