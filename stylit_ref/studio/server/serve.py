"""Serve a studio until somebody interrupts it."""

import asyncio
import socket
from collections.abc import Callable, Sequence
from contextlib import ExitStack

import uvicorn
from starlette.types import ASGIApp
from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol

from stylit_ref.studio.painting.watch import Watch, Watcher
from stylit_ref.studio.server.access import Access
from stylit_ref.studio.server.app import make_app
from stylit_ref.studio.server.beginning import Beginning
from stylit_ref.studio.server.desk import Desk, Engine
from stylit_ref.studio.server.panel import Panel
from stylit_ref.studio.server.protocol import LARGEST_MESSAGE

_LAST_WORDS = 2
"""Seconds that answers have to end."""


def serve(
    beginning: Beginning,
    engine: Engine,
    door: socket.socket,
    access: Access,
    *,
    panels: Sequence[Panel] = (),
    listens: Callable[[], None],
) -> None:
    """Serve it. The painting is saved whenever this ends, and however.

    Parameters
    ----------
    beginning : Beginning
    engine : callable
    door : socket
        Listens already; is closed at the end.
    access : Access
        Of the door's port.
    panels : sequence of Panel
    listens : callable
        Called once, when requests are answered.

    Raises
    ------
    KeyboardInterrupt
        When interrupted.
    """

    async def run() -> None:
        with ExitStack() as ends:
            desk = Desk(beginning, engine, [panel.name for panel in panels])
            server = _Server(_config(make_app(access, desk, beginning, panels)), listens)
            # Until all is saved, so that another Ctrl-C meanwhile does not skip that.
            ends.enter_context(server.capture_signals())
            ends.callback(desk.close)
            for panel in panels:
                ends.callback(panel.close)
            if beginning.watch:
                ends.callback(_watching(beginning.watch, desk).close)
            await server.serve([door])

    asyncio.run(run())


class _Server(uvicorn.Server):
    """Tells when it listens."""

    def __init__(self, config: uvicorn.Config, listens: Callable[[], None]) -> None:
        super().__init__(config)
        self._listens = listens

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self._listens()


def _config(app: ASGIApp) -> uvicorn.Config:
    return uvicorn.Config(
        app,
        http="h11",
        ws=WebSocketsSansIOProtocol,
        ws_max_size=LARGEST_MESSAGE,
        ws_per_message_deflate=False,  # it would take longer than the way through one machine
        lifespan="off",
        log_config=None,
        log_level="critical",  # what hostile requests do to its parsers is no news
        access_log=False,
        proxy_headers=False,
        server_header=False,
        timeout_graceful_shutdown=_LAST_WORDS,
    )


def _watching(watch: Watch, desk: Desk) -> Watcher:
    return Watcher(watch, desk.from_thread(lambda found: desk.watched(found, str(watch.file))))
