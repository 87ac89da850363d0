"""The viewer's page of finished views, in a frame of its own."""

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from stylit_ref.studio.server.panel import Panel

_POLICY = (
    "sandbox allow-scripts allow-downloads; default-src 'none'; script-src 'unsafe-inline'; "
    "style-src 'unsafe-inline'; img-src blob: data:; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'self'"
)
"""Its program is within it. In a sandbox that can ask the studio for nothing."""


def views_panel(page: bytes) -> Panel:
    """``/views/``.

    Parameters
    ----------
    page : bytes
        HTML in windows-1252.
    """

    async def answer(request: Request) -> Response:
        kind = "text/html; charset=windows-1252"
        return Response(page, headers={"Content-Security-Policy": _POLICY}, media_type=kind)

    return Panel("views", [Route("/views/", answer)])
