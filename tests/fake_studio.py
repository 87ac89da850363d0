"""A small server that speaks the studio's protocol: its picture is the painting's negative."""

import asyncio
import io
import json
import socket
import struct
import threading
import time
from pathlib import Path

import numpy as np
import uvicorn
from PIL import Image
from starlette.applications import Starlette
from starlette.responses import JSONResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocketDisconnect

ROOM = Path(__file__).parents[1] / "stylit_ref/studio"
CSP = (
    "default-src 'self'; connect-src 'self' ws://{host}; img-src 'self' blob: data:; "
    "object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
WHICH = "replay", "coherent", "warm", "fast", "full", "step", "look"
FIELDS = (
    {"name": "levels", "kind": "integer", "least": 1, "most": 12, "help": "levels", "of": "live"},
    {"name": "mu", "kind": "several", "least": 0, "most": 16, "help": "weight of the style",
     "of": "live"},
    {"name": "radii", "kind": "several", "least": 0, "most": 32768, "help": "radii", "of": "live"},
    {"name": "spacing", "kind": "integer", "least": 2, "most": 13, "help": "pixels between entries",
     "of": "live", "optional": True},
    {"name": "start", "kind": "choice", "choices": ["vote", "bilinear"], "help": "how a level "
     "begins", "of": "live"},
    {"name": "labels", "kind": "flag", "help": "match only the same label", "of": "live"},
    {"name": "lambda", "kind": "number", "least": 0, "most": 1, "help": "occurrences",
     "of": "dense"},
)  # fmt: skip
VALUES = {
    "levels": 3, "mu": [4, 4, 0], "radii": [4, 16, 32768], "spacing": None, "start": "vote",
    "labels": True, "lambda": 0.5,
}  # fmt: skip


class FakeStudio:
    """A server in a thread.

    Attributes
    ----------
    painting : (H, W, 3) uint8
        As far as it has been sent.
    asked : list of dict
        What pages asked, but for ``hello``.
    rectangles : list of (x, y, width, height, serial)
        Those that pages sent.
    name : str
        Of the painting's folder.
    """

    def __init__(self, size=(120, 160), *, serial=0, panels=("scan",), port=0):
        rng = np.random.default_rng(7)
        self.beginning = rng.integers(90, 220, (*size, 3), dtype=np.uint8)
        self.painting = self.beginning.copy()
        self.name = "oils"
        self.serial, self.panels = serial, list(panels)
        self.layers = ["FULL", "LDE", "NORMAL"]
        self.asked, self.rectangles, self.sockets = [], [], []
        self.texture = np.full((24, 32, 3), (30, 160, 90), np.uint8)
        self.port = port
        self.start()

    def start(self):
        """Serve, on the port of before if there was one."""
        listener = socket.socket()
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind(("127.0.0.1", self.port))
        self.port = listener.getsockname()[1]
        routes = [
            Route("/", self._page("page.html")),
            Route("/studio.css", self._page("page.css")),
            Route("/studio.js", self._page("bundle/studio.js")),
            Route("/thumb/{scene}/{side}/{buffer}", self._thumb),
            Route("/texture/{name}", self._texture, methods=["GET", "POST"]),
            Route("/scan", self._scan, methods=["POST"]),
            Route("/scan/corners", self._corners, methods=["POST"]),
            WebSocketRoute("/live", self._live),
        ]
        config = uvicorn.Config(
            Starlette(routes=routes),
            log_level="critical",
            timeout_graceful_shutdown=1,
            ws_per_message_deflate=False,
        )
        self.server = uvicorn.Server(config)
        self.thread = threading.Thread(
            target=self.server.run, kwargs={"sockets": [listener]}, daemon=True
        )
        self.thread.start()
        _until(lambda: self.server.started)

    def stop(self):
        """Go, as a server does that is ended."""
        self.server.force_exit = self.server.should_exit = True
        self.thread.join(10)
        assert not self.thread.is_alive()
        self.sockets = []

    @property
    def address(self):
        """Where its page is."""
        return f"http://127.0.0.1:{self.port}/"

    def welcome(self, role):
        """What a page is told first."""
        height, width = self.painting.shape[:2]
        golem = {
            "name": "golem", "title": "Golem", "steps": 12, "width": width, "height": height,
            "buffers": self.layers[:2], "layers": self.layers,
        }  # fmt: skip
        still = golem | {"name": "teapot", "title": "Teapot", "steps": 1, "layers": []}
        return {
            "say": "welcome", "version": 2, "role": role, "page": "a page",
            "scenes": [golem, still],
            "painting": {
                "width": width, "height": height, "name": self.name, "serial": self.serial,
            },
            "parameters": {"values": VALUES, "fields": FIELDS}, "weights": {"FULL": 2}, "step": 0,
            "scene": "golem", "seed": 5, "layers": self.layers[:2], "panels": self.panels,
            "notes": [],
        }  # fmt: skip

    def say(self, what, number=0):
        """Say something to a page, as JSON or as bytes, from another thread."""
        asyncio.run_coroutine_threadsafe(_send(self.sockets[number], what), self.loop).result(10)

    def picture(self, which, image, milliseconds=1.5):
        """The message that brings a picture."""
        return _frame(1, WHICH.index(which), image, self.serial, milliseconds)

    def painting_message(self, image, serial):
        """The message that brings a painting."""
        return _frame(2, 0, image, serial, 0.0)

    def asks(self, what):
        """Wait for what a page asks, and give the last such message."""
        _until(lambda: any(asked["do"] == what for asked in self.asked))
        return [asked for asked in self.asked if asked["do"] == what][-1]

    def rests(self, serial):
        """Wait until a page has said that the brush rests after so many messages."""
        _until(lambda: {"do": "rest", "serial": serial} in self.asked)

    async def _live(self, socket):
        await socket.accept()
        self.loop = asyncio.get_running_loop()
        assert await socket.receive_json() == {"do": "hello", "version": 2}
        self.sockets.append(socket)
        role = "painter" if len(self.sockets) == 1 else "reader"
        await self._greet(socket, role)
        try:
            while True:
                message = await socket.receive()
                if message["type"] == "websocket.disconnect":
                    break
                if message.get("bytes"):
                    await self._paint(socket, message["bytes"])
                else:
                    await self._answer(socket, message["text"])
        except WebSocketDisconnect:
            pass
        if socket in self.sockets:
            self.sockets.remove(socket)

    async def _greet(self, socket, role):
        await _send(socket, self.welcome(role))
        await _send(socket, self.painting_message(self.beginning, 0))
        if self.serial:
            await _send(socket, self.painting_message(self.painting, self.serial))
        await _send(socket, self.picture("coherent", 255 - self.painting, 42.0))

    async def _paint(self, socket, message):
        _, _, x, y, width, height, self.serial = struct.unpack_from("<BBHHHHI", message)
        pixels = np.frombuffer(message, np.uint8, offset=14).reshape(height, width, 3)
        self.painting[y : y + height, x : x + width] = pixels
        self.rectangles.append((x, y, width, height, self.serial))
        await _send(socket, self.picture("replay", 255 - self.painting))
        for other in self.sockets:
            if other is not socket:
                await _send(other, self.painting_message(self.painting, self.serial))

    async def _answer(self, socket, text):
        asked = json.loads(text)
        self.asked.append(asked)
        if asked["do"] == "rest":
            await _send(socket, self.picture("coherent", 255 - self.painting, 42.0))
            await _send(socket, {"say": "saved", "text": "Saved"})
        elif asked["do"] == "look":
            look = np.full((6, 8, 3), 77, np.uint8)
            number = WHICH.index("look")
            await _send(socket, _frame(1, number, look, self.serial, 1.5, asked["what"]))
        elif asked["do"] == "step":
            await _send(socket, self.picture("step", 255 - self.painting, 3.0))
            state = {"level": 2, "iteration": 1, "done": False, "possible": ["half", "blend"]}
            await _send(socket, {"say": "stepped", **state})
        elif asked["do"] == "export":
            commands = ["stylit-ref run golem.png --style style.png --output picture.png"]
            exported = {
                "folder": "/oil/exports/001",
                "files": ["picture.png"],
                "commands": commands,
            }
            await _send(socket, {"say": "exported"} | exported)
        elif asked["do"] == "take_over":
            for other in self.sockets:
                if other is not socket:
                    await _send(other, {"say": "role", "role": "reader"})
            await _send(socket, {"say": "role", "role": "painter"})
            await self._greet(socket, "painter")

    def _page(self, name):
        kinds = {"html": "text/html", "css": "text/css", "js": "text/javascript"}

        async def answer(request):
            headers = {"Content-Security-Policy": CSP.format(host=f"127.0.0.1:{self.port}")}
            kind = kinds[name.rsplit(".")[-1]]
            return Response((ROOM / name).read_bytes(), media_type=kind, headers=headers)

        return answer

    async def _thumb(self, request):
        return _png(np.full((34, 44, 3), 128, np.uint8))

    async def _texture(self, request):
        name = request.path_params["name"]
        if name == "exemplar":
            return _png(np.full((16, 16, 3), (90, 160, 30), np.uint8))
        if name == "drop":
            asked = await request.json()
            self.asked.append({"do": "drop", **asked})
            x, y = asked["to"]
            self.texture[y, x] = 255
        return _png(self.texture)

    async def _scan(self, request):
        self.photograph = await request.body()
        assert request.headers["stylit-page"] == "a page"
        text = "The marks of the sheet were not found. Drag the corners onto them."
        return JSONResponse({"text": text, "corners": None, "width": 40, "height": 30})

    async def _corners(self, request):
        self.asked.append({"do": "corners", **await request.json()})
        return JSONResponse({"text": "The sheet is the painting now."})


async def _send(socket, what):
    if isinstance(what, bytes):
        await socket.send_bytes(what)
    else:
        await socket.send_json(what)


def _frame(kind, which, image, serial, milliseconds, of=""):
    height, width = image.shape[:2]
    head = struct.pack("<BBHHHIf", kind, which, width, height, len(of), serial, milliseconds)
    return head + of.encode() + np.ascontiguousarray(image).tobytes()


def _png(image):
    file = io.BytesIO()
    Image.fromarray(image).save(file, "PNG")
    return Response(file.getvalue(), media_type="image/png")


def _until(holds):
    end = time.monotonic() + 10
    while not holds():
        assert time.monotonic() < end, "it did not come to pass in ten seconds"
        time.sleep(0.01)
