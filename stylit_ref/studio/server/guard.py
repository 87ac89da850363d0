"""Around the whole application: who may come in, and what every answer says."""

import logging

from starlette.datastructures import MutableHeaders
from starlette.responses import PlainTextResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from stylit_ref.studio.server.access import Access, Refusal

LOGGER: logging.Logger = logging.getLogger("stylit_ref.studio")

_NO_TOKEN = Refusal(
    403, "Open the studio by the whole address that its terminal shows, with the token in it."
)


class Guard:
    """Lets in whom :class:`Access` lets in; a failure of the studio itself is one sentence, too.

    Parameters
    ----------
    app : ASGI application
        What is guarded.
    access : Access
    """

    def __init__(self, app: ASGIApp, access: Access) -> None:
        self._app, self._access = app, access
        sockets = " ".join(f"ws://{host}" for host in access.hosts)  # 'self' has none in old Safari
        self._policy = (
            f"default-src 'self'; connect-src 'self' {sockets}; img-src 'self' blob: data:; "
            "object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
        )

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request, or one socket as long as it lives."""
        is_socket = scope["type"] == "websocket"
        has_begun = False

        async def sealed(message: Message) -> None:
            nonlocal has_begun
            has_begun = True
            if message["type"].endswith("response.start"):
                self._seal(MutableHeaders(scope=message))
            await send(message)

        answer = self._answer(scope, is_socket)
        try:
            await (answer or self._app)(scope, receive, sealed)
        except Exception:
            LOGGER.exception("the studio failed at %s; please report it", scope["path"])
            if not has_begun:
                sorry = PlainTextResponse("The studio failed; its terminal says more.", 500)
                await sorry(scope, receive, sealed)

    def _answer(self, scope: Scope, is_socket: bool) -> Response | None:
        """What is said at the door; None for whoever may come in."""
        headers, access = scope["headers"], self._access
        refusal = access.refusal(scope.get("method", "GET"), headers, is_socket=is_socket)
        is_first = not is_socket and scope["path"] == "/"
        if refusal is None and is_first and access.has_token(scope["query_string"]):
            return RedirectResponse("/", 303, {"Set-Cookie": access.cookie})
        if refusal is None and not access.has_cookie(headers):
            refusal = _NO_TOKEN
        return PlainTextResponse(refusal.sentence + "\n", refusal.status) if refusal else None

    def _seal(self, headers: MutableHeaders) -> None:
        """Say to the browser what this page may do, unless its own answer has said so."""
        headers.setdefault("Content-Security-Policy", self._policy)
        headers["X-Content-Type-Options"] = "nosniff"
        headers["Referrer-Policy"] = "no-referrer"
        headers["Cache-Control"] = "no-store"
        headers["Cross-Origin-Resource-Policy"] = "same-origin"
        headers["Cross-Origin-Opener-Policy"] = "same-origin"
