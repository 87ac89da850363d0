"""Requests that only the page that paints may send."""

from starlette.exceptions import HTTPException
from starlette.requests import Request

from stylit_ref.studio.server.desk import LOOKS_ON

_PAGE = "stylit-page"
"""The header by which a page names itself; it was told its name through its socket."""


def refuse_readers(request: Request) -> None:
    """Let the page that paints go on.

    Raises
    ------
    HTTPException
        If the request is of a page that looks on, or of none.
    """
    if not request.app.state.desk.is_painter(request.headers.get(_PAGE, "")):
        raise HTTPException(403, LOOKS_ON)
