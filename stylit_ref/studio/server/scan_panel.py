"""A sheet to print and paint on, and what a scan or photograph of it shows."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from stylit_ref.errors import InputError
from stylit_ref.studio.server.body import json_body, points
from stylit_ref.studio.server.in_thread import in_thread
from stylit_ref.studio.server.painters import refuse_readers
from stylit_ref.studio.server.panel import Panel
from stylit_ref.studio.server.protocol import sentence
from stylit_ref.studio.sheet.photograph import read_photograph

if TYPE_CHECKING:
    from stylit_ref.studio.sheet.register import Registered

_TAKEN = "The painting is that of the scan."


def scan_panel() -> Panel:
    """``/sheet.pdf``, ``/scan`` and ``/scan/corners``, of the scene that is open.

    What needs SciPy is imported by who asks for it first, so that the page opens without it.
    """
    last: list[bytes] = []  # what was sent last

    async def sheet(request: Request) -> Response:
        offer = request.app.state.desk.offer

        def printed() -> bytes:
            from stylit_ref.studio.sheet.print_sheet import print_sheet

            return print_sheet(offer.rendering(), offer.things())

        content = await in_thread(printed)
        return Response(content, media_type="application/pdf")

    async def scan(request: Request) -> Response:
        refuse_readers(request)
        last[:] = [await request.body()]
        photograph = await in_thread(lambda: read_photograph(last[0]))
        height, width = photograph.shape[:2]
        told: dict[str, Any] = {"width": width, "height": height, "corners": None}
        size = request.app.state.desk.offer.size[::-1]

        def look() -> "Registered | InputError":
            from stylit_ref.studio.sheet.register import register

            try:
                return register(photograph, size)
            except InputError as error:
                return error

        found = await in_thread(look)
        if isinstance(found, InputError):
            return JSONResponse({**told, "text": sentence(found)})
        _take(request, found.painting)
        return JSONResponse({**told, "text": _TAKEN, "corners": found.corners.tolist()})

    async def scan_corners(request: Request) -> Response:
        refuse_readers(request)
        corners = points(await json_body(request), "corners", 4)
        if not last:
            raise HTTPException(404, "Send a photograph first.")
        content = last[0]
        size = request.app.state.desk.offer.size[::-1]

        def registered() -> NDArray[np.uint8]:
            from stylit_ref.studio.sheet.register import register_corners

            return register_corners(read_photograph(content), corners, size)

        painting = await in_thread(registered)
        _take(request, painting)
        return JSONResponse({"text": _TAKEN})

    return Panel(
        "scan",
        [
            Route("/sheet.pdf", sheet),
            Route("/scan", scan, methods=["POST"]),
            Route("/scan/corners", scan_corners, methods=["POST"]),
        ],
    )


def _take(request: Request, painting: NDArray[np.uint8]) -> None:
    """Make it the painting, or say why not."""
    try:
        request.app.state.desk.replace_painting(painting, _TAKEN)
    except InputError as error:
        raise HTTPException(400, sentence(error)) from None
