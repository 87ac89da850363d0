"""A page's socket, as long as it is open."""

import asyncio
from contextlib import suppress

from starlette.websockets import WebSocket, WebSocketDisconnect

from stylit_ref.studio.server.desk import Desk, Visitor
from stylit_ref.studio.server.protocol import (
    VERSION,
    Hello,
    ProtocolError,
    parse_paint,
    parse_wish,
    said,
)

_OTHER_VERSION = 4000

_LONGEST_REASON = 123
"""Bytes (RFC 6455, 5.5)."""


async def live(socket: WebSocket, desk: Desk) -> None:
    """Serve a page until it leaves, or says what no page of this version says.

    Parameters
    ----------
    socket : WebSocket
        Of a request that the guard has let in.
    desk : Desk
    """
    await socket.accept()
    visitor = Visitor()
    sending = asyncio.create_task(_send(socket, visitor))
    refusal = None
    try:
        await _listen(socket, desk, visitor)
    except ProtocolError as error:
        refusal = error
    except WebSocketDisconnect:
        pass
    finally:
        desk.leave(visitor)
        sending.cancel()
        with suppress(asyncio.CancelledError):
            await sending
    if refusal:
        with suppress(WebSocketDisconnect):
            await socket.send_text(said("problem", {"text": str(refusal)}))
            await socket.close(refusal.code, _reason(refusal))


def _reason(refusal: ProtocolError) -> str:
    """What fits into a frame that closes a socket."""
    return str(refusal).encode("ascii", "replace")[:_LONGEST_REASON].decode()


async def _listen(socket: WebSocket, desk: Desk, visitor: Visitor) -> None:
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        text, paint = message.get("text"), message.get("bytes")
        wish = None if text is None else parse_wish(text)
        if isinstance(wish, Hello):
            if wish.version != VERSION:
                raise ProtocolError("The page is of another version; reload it.", _OTHER_VERSION)
            desk.join(visitor)
        elif not desk.knows(visitor):
            raise ProtocolError("A page says hello first.")
        elif wish is not None:
            await desk.grant(visitor, wish)
        else:
            desk.paint(visitor, parse_paint(paint or b"", desk.size, desk.left_behind))


async def _send(socket: WebSocket, visitor: Visitor) -> None:
    with suppress(WebSocketDisconnect):
        while True:
            message = await visitor.outbox.next()
            if isinstance(message, str):
                await socket.send_text(message)
            else:
                await socket.send_bytes(message)
