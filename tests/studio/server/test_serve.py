"""A real server: its port, its sockets, how it ends."""

import asyncio
import json
import os
import signal
import socket
import stat
import threading

import pytest
from studio.server.test_desk import image_of, stroke
from studio.small_studio import NotedEngine, small_beginning
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed, InvalidStatus

from stylit_ref import InputError, read_image
from stylit_ref.studio.server.access import Access
from stylit_ref.studio.server.door import USUAL_PORT, open_door, port_of
from stylit_ref.studio.server.panel import Panel
from stylit_ref.studio.server.protocol import LARGEST_MESSAGE
from stylit_ref.studio.server.serve import serve
from stylit_ref.studio.server.way_in import way_in


@pytest.fixture
def served(tmp_path):
    """Serve a small studio while a coroutine of the test runs in another thread.

    As a program it is interrupted in the end.
    """

    def run(visit, panels=()):
        door = open_door(0)
        access, failures = Access(port_of(door)), []

        def visiting():
            try:
                asyncio.run(visit(access))
            except BaseException as failure:
                failures.append(failure)
            os.kill(os.getpid(), signal.SIGINT)

        visitor = threading.Thread(target=visiting)
        with pytest.raises(KeyboardInterrupt):
            serve(
                small_beginning(tmp_path), NotedEngine, door, access, panels=panels,
                listens=visitor.start,
            )  # fmt: skip
        visitor.join()
        if failures:
            raise failures[0]

    return run


def page(access, *, origin=True, cookie=True):
    """Connect as a page does."""
    own = f"127.0.0.1:{access.port}"
    headers = {"Cookie": f"{access.cookie_name}={access.secret}"} if cookie else {}
    return connect(
        f"ws://{own}/live",
        origin=f"http://{own}" if origin else None,
        additional_headers=headers,
        max_size=None,
        proxy=None,
    )


def test_a_page_paints_and_the_painting_is_saved_when_it_ends(served, tmp_path, capfd):
    async def visit(access):
        async with page(access) as live:
            assert "Sec-WebSocket-Extensions" not in live.response.headers  # no compression
            await live.send('{"do": "hello", "version": 2}')
            assert json.loads(await live.recv())["say"] == "welcome"
            assert image_of(await live.recv())[1] == 0
            await live.send(stroke(5))
            image, serial = image_of(await live.recv())
            assert serial == 5
            assert (image[4:6, 3:8] == 200).all()

    served(visit)
    assert (read_image(tmp_path / "painting" / "style.png")[4:6, 3:8] == 200).all()
    said = capfd.readouterr()
    assert said.out + said.err == ""


def test_a_second_interruption_while_it_ends_does_not_skip_the_last_save(served, tmp_path):
    async def visit(access):
        async with page(access) as live:
            await live.send('{"do": "hello", "version": 2}')
            await live.send(stroke(5))

    def impatient():
        os.kill(os.getpid(), signal.SIGINT)

    served(visit, [Panel("impatient", [], impatient)])
    assert (read_image(tmp_path / "painting" / "style.png")[4:6, 3:8] == 200).all()


def test_strangers_and_broken_frames_are_refused_without_a_word_in_the_log(served, capfd):
    async def visit(access):
        for more in ({"origin": False}, {"cookie": False}):
            with pytest.raises(InvalidStatus) as refused:
                async with page(access, **more):
                    pass
            assert refused.value.response.status_code == 403
            assert refused.value.response.body.endswith(b".\n")
        too_long = b"\x82\xff" + (LARGEST_MESSAGE + 1).to_bytes(8) + bytes(4)
        for raw, code in (
            (b"\x81\x82\0\0\0\0\xff\xff", 1007),  # a text that is not UTF-8
            (b"\xff" * 20, 1002),  # reserved bits
            (b"\x83\x80\0\0\0\0", 1002),  # a reserved opcode
            (too_long, 1009),
        ):
            async with page(access) as live:
                live.transport.write(raw)
                with pytest.raises(ConnectionClosed) as closed:
                    await live.recv()
                assert closed.value.rcvd.code == code
        for request in (b"\0\r\n\r\n", b"GET / HTTP/1.1\r\n\r\n", b"GET " + b"a" * 100000):
            reader, writer = await asyncio.open_connection("127.0.0.1", access.port)
            writer.write(request)
            assert (await reader.read(12))[9:12] in (b"400", b"403")
            writer.close()
        async with page(access) as live:
            await live.send('{"do": "hello", "version": 2}')
            assert json.loads(await live.recv())["role"] == "painter"

    served(visit)
    said = capfd.readouterr()
    assert said.out + said.err == ""


def test_a_picture_does_not_wait_for_acknowledgement():
    with open_door(0) as door, socket.create_connection(door.getsockname()):
        accepted, _ = door.accept()
        with accepted:
            assert accepted.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY)


def test_a_port_that_is_taken_is_refused_by_name_and_passed_over_without():
    with open_door(0) as taken:
        with pytest.raises(InputError, match="which another program listens at") as refused:
            open_door(port_of(taken))
        assert refused.value.parameter == "port"
    try:
        usual = socket.create_server(("127.0.0.1", USUAL_PORT))
    except OSError:
        pytest.skip(f"another program listens at {USUAL_PORT}")
    with usual, open_door(None) as door:
        assert USUAL_PORT < port_of(door) < USUAL_PORT + 20
        assert door.getsockname()[0] == "127.0.0.1"


def test_the_way_in_is_for_its_owner_alone_and_goes_in_the_end(tmp_path):
    file = tmp_path / "open_studio.html"
    file.write_text("of a studio that was killed")
    file.chmod(0o644)
    address = "http://127.0.0.1:8517/?token=abc"
    with way_in(tmp_path, address) as own:
        assert own == file.as_uri()
        assert f"url={address}" in file.read_text()
        if os.name == "posix":
            assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert not file.exists()
