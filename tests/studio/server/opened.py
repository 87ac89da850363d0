"""A studio that is open for a test's coroutine."""

import asyncio
import functools
from contextlib import asynccontextmanager
from typing import NamedTuple

from starlette.types import ASGIApp
from studio.asgi import Socket, ask, headers_of
from studio.small_studio import NotedEngine, small_beginning

from stylit_ref.studio.server.access import Access
from stylit_ref.studio.server.app import make_app
from stylit_ref.studio.server.desk import Desk

PORT = 8517


class Opened(NamedTuple):
    """A studio, and a page's way to ask it."""

    app: ASGIApp
    access: Access
    desk: Desk
    engine: NotedEngine

    async def get(self, path, **more):
        return await ask(self.app, path, headers_of(self.access, **more))

    async def post(self, path, body, **more):
        headers = headers_of(self.access, **more)
        return await ask(self.app, path, headers, method="POST", body=body)

    def socket(self):
        return Socket(self.app, headers_of(self.access))

    async def page(self):
        """Open a page: its socket, and what posts in its name."""
        socket = self.socket()
        name = (await socket.hello())["page"]
        return socket, functools.partial(self.post, **{"stylit-page": name})


@asynccontextmanager
async def opened(folder, panels=(), beginning=None, **more):
    """Open one in a folder."""
    engines = []

    def engine(*arguments):
        engines.append(NotedEngine(*arguments))
        return engines[0]

    beginning = beginning or small_beginning(folder, **more)
    desk = Desk(beginning, engine, [panel.name for panel in panels])
    access = Access(PORT)
    try:
        yield Opened(make_app(access, desk, beginning, panels), access, desk, engines[0])
    finally:
        await asyncio.to_thread(desk.close)


def in_loop(coroutine):
    """Run a test that is a coroutine."""

    @functools.wraps(coroutine)
    def test(*arguments, **fixtures):
        return asyncio.run(coroutine(*arguments, **fixtures))

    return test
