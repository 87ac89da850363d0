"""Ask an application without a network: requests, and sockets."""

import asyncio
import json
from typing import NamedTuple

from studio.whole_picture import whole_picture


class Answer(NamedTuple):
    """What came back."""

    status: int
    headers: dict
    body: bytes


def headers_of(access, *, cookie=True, origin=True, host=None, **more):
    """What a browser sends from the studio's own page; ``None`` leaves a header out."""
    own = f"127.0.0.1:{access.port}" if host is None else host
    sent = {
        "host": own,
        "origin": f"http://{own}" if origin else None,
        "cookie": f"{access.cookie_name}={access.secret}" if cookie else None,
        **more,
    }
    return [(k.encode(), v.encode("latin-1")) for k, v in sent.items() if v is not None]


async def ask(app, path, headers, *, method="GET", query=b"", body=b""):
    """Send a request, and return the whole answer."""
    scope = {
        "type": "http", "asgi": {"version": "3.0"}, "http_version": "1.1", "method": method,
        "scheme": "http", "path": path, "raw_path": path.encode("utf-8", "surrogateescape"),
        "query_string": query, "root_path": "", "headers": headers,
        "client": ("127.0.0.1", 1), "server": ("127.0.0.1", 2),
    }  # fmt: skip
    incoming = [{"type": "http.request", "body": body, "more_body": False}]
    outgoing = []

    async def receive():
        return incoming.pop() if incoming else await asyncio.Event().wait()

    async def send(message):
        outgoing.append(message)

    await app(scope, receive, send)
    start, *parts = outgoing
    said = {name.decode(): value.decode("latin-1") for name, value in start["headers"]}
    return Answer(start["status"], said, b"".join(part.get("body", b"") for part in parts))


class Socket:
    """A page's socket.

    Attributes
    ----------
    status : int or None
        Of a refusal.
    code : int or None
        That it was closed with.
    """

    def __init__(self, app, headers, path="/live"):
        self.status = self.code = self._picture = None
        self._to_app, self._from_app = asyncio.Queue(), asyncio.Queue()
        self._to_app.put_nowait({"type": "websocket.connect"})
        scope = {
            "type": "websocket", "asgi": {"version": "3.0"}, "http_version": "1.1", "scheme": "ws",
            "path": path, "raw_path": path.encode(), "query_string": b"", "root_path": "",
            "headers": headers, "client": ("127.0.0.1", 1), "server": ("127.0.0.1", 2),
            "subprotocols": [], "extensions": {"websocket.http.response": {}},
        }  # fmt: skip
        self._task = asyncio.create_task(app(scope, self._to_app.get, self._from_app.put))

    async def open(self):
        """Whether it was let in."""
        message = await self._next()
        self.status = message.get("status")
        return message["type"] == "websocket.accept"

    async def hello(self):
        """Say hello; returns the welcome."""
        assert await self.open()
        self.say(do="hello", version=2)
        return await self.said("welcome")

    def say(self, **words):
        self.text(json.dumps(words))

    def text(self, text):
        self._to_app.put_nowait({"type": "websocket.receive", "text": text})

    def bytes(self, content):
        self._to_app.put_nowait({"type": "websocket.receive", "bytes": content})

    async def said(self, word):
        """The next text of a kind; others are passed over."""
        while True:
            message = await self._next()
            if message.get("text"):
                words = json.loads(message["text"])
                if words["say"] == word:
                    return words

    async def shown(self, kind):
        """The next picture (1) or painting (2), as bytes of all of it."""
        while True:
            message = await self._next()
            if message.get("bytes") and message["bytes"][0] == kind:
                return message["bytes"]

    async def closed(self):
        """Wait until it is closed; returns the texts that came before."""
        texts = []
        while True:
            message = await self._next()
            if message["type"] == "websocket.close":
                self.code = message["code"]
                await self._task
                return texts
            if message.get("text"):
                texts.append(json.loads(message["text"]))

    async def leave(self):
        self._to_app.put_nowait({"type": "websocket.disconnect", "code": 1001})
        await self._task

    async def _next(self):
        message = await asyncio.wait_for(self._from_app.get(), 5)
        if (message.get("bytes") or b"\0")[0] in (1, 3):
            self._picture = message["bytes"] = whole_picture(message["bytes"], self._picture)
        return message
