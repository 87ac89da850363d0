"""Who gets in: one case for each reason, then a thousand of each kind that somebody may try."""

import asyncio
import json
import logging

import pytest
from hostile.generated import generated
from hypothesis import assume
from hypothesis import strategies as st
from starlette.responses import PlainTextResponse
from starlette.routing import Route
from studio.asgi import Socket, ask, headers_of
from studio.server.opened import PORT, in_loop, opened

from stylit_ref.studio.server import protocol
from stylit_ref.studio.server.access import Access
from stylit_ref.studio.server.panel import Panel
from stylit_ref.studio.server.protocol import ProtocolError, parse_paint, parse_wish

CASES = 1000
SECRET = "what lies beside the folders"
OWN = f"127.0.0.1:{PORT}"


@pytest.fixture
def studio(tmp_path, caplog, capfd):
    """A studio and what runs coroutines; afterwards it must still serve, and have said nothing."""
    (tmp_path / "secret.txt").write_text(SECRET)
    with asyncio.Runner() as runner:
        room = opened(tmp_path)
        found = runner.run(room.__aenter__())
        yield found, runner.run
        assert runner.run(found.get("/studio.css")).status == 200
        runner.run(room.__aexit__(None, None, None))
    assert [record for record in caplog.records if record.levelno >= logging.ERROR] == []
    assert "Traceback" not in capfd.readouterr().err


def test_the_page_and_its_socket_get_in(studio):
    found, run = studio

    async def visit():
        socket = found.socket()
        assert (await socket.hello())["role"] == "painter"
        await socket.leave()

    run(visit())
    page = run(found.get("/"))
    assert page.status == 200
    assert "default-src 'self'" in page.headers["content-security-policy"]
    assert "unsafe" not in page.headers["content-security-policy"]
    assert page.headers["x-content-type-options"] == "nosniff"
    assert page.headers["referrer-policy"] == "no-referrer"
    assert page.headers["cache-control"] == "no-store"


def test_the_token_is_exchanged_for_a_cookie(studio):
    found, run = studio
    access = found.access
    headers = headers_of(access, cookie=False, origin=False)
    answer = run(ask(found.app, "/", headers, query=f"token={access.token}".encode()))
    assert answer.status == 303
    assert answer.headers["location"] == "/"
    cookie = answer.headers["set-cookie"]
    assert cookie.endswith("; HttpOnly; SameSite=Lax; Path=/")
    assert access.token not in cookie
    sent = cookie.partition(";")[0]
    assert run(found.get("/", cookie=False, origin=False)).status == 403
    headers.append((b"cookie", f"other=1; {sent}".encode()))
    assert run(ask(found.app, "/", headers)).status == 200


def test_servers_have_tokens_of_their_own():
    one, other = Access(PORT), Access(PORT)
    cookie = [(b"cookie", f"{other.cookie_name}={other.secret}".encode())]
    assert not one.has_cookie(cookie)
    assert not one.has_token(f"token={other.token}".encode())
    assert one.address == f"http://127.0.0.1:{PORT}/?token={one.token}"


def test_what_changes_something_needs_an_origin(studio):
    found, run = studio
    assert run(found.get("/", origin=False)).status == 200
    assert run(found.post("/scan/corners", b"{}", origin=False)).status == 403


def test_another_name_of_this_machine_is_another_origin(studio):
    found, run = studio
    assert run(found.get("/", host=f"localhost:{PORT}")).status == 200
    mixed = headers_of(found.access, origin=False, host=f"localhost:{PORT}")
    assert run(ask(found.app, "/", [*mixed, (b"origin", f"http://{OWN}".encode())])).status == 403


def test_two_hosts_are_none(studio):
    found, run = studio
    twice = [*headers_of(found.access), (b"host", OWN.encode())]
    assert run(ask(found.app, "/", twice)).status == 403


@pytest.mark.parametrize("method", ["PUT", "DELETE", "OPTIONS", "TRACE", "PATCH", "CONNECT"])
def test_other_methods_are_refused(studio, method):
    found, run = studio
    answer = run(ask(found.app, "/", headers_of(found.access), method=method))
    assert answer.status == 405
    assert answer.body.count(b"\n") == 1


@in_loop
async def test_a_body_that_is_too_large_is_refused(tmp_path):
    async def length(request):
        return PlainTextResponse(str(len(await request.body())))

    panel = Panel("length", [Route("/length", length, methods=["POST"])])
    async with opened(tmp_path, [panel]) as found:
        largest = bytes(protocol.LARGEST_MESSAGE)
        assert (await found.post("/length", largest)).status == 200
        answer = await found.post("/length", largest + b"1")
        assert answer.status == 413
        assert answer.body == b"That is more than 64 MB.\n"


LATIN = st.characters(max_codepoint=255, exclude_characters="\r\n\0")
HOSTS = st.one_of(
    st.text(LATIN, max_size=40),
    st.sampled_from(
        [
            "", "localhost", "127.0.0.1", "127.0.0.1:80", f"127.1:{PORT}", f"0.0.0.0:{PORT}",
            f"[::1]:{PORT}", f"LOCALHOST:{PORT}", f"localhost.:{PORT}", f"evil.org:{PORT}",
            f"localhost:{PORT}.evil.org", f"localhost:{PORT}@evil.org", f"2130706433:{PORT}",
        ]
    ),
    st.tuples(st.text(LATIN, max_size=3), st.sampled_from([OWN, f"localhost:{PORT}"]),
              st.text(LATIN, max_size=3)).map("".join),
    st.integers(0, 70000).map("127.0.0.1:{}".format),
    st.from_regex(r"[a-z0-9.-]{1,20}(:8517)?", fullmatch=True),
)  # fmt: skip


def test_other_hosts_are_refused(studio):
    found, run = studio

    @generated(CASES, host=HOSTS, is_socket=st.booleans())
    def refused(host, is_socket):
        assume(host not in found.access.hosts)
        headers = headers_of(found.access, host=host)
        assert run(_status(found.app, headers, is_socket)) == 403

    refused()


ORIGINS = st.one_of(
    st.sampled_from(
        ["", "null", f"https://{OWN}", f"http://{OWN}/", f"http://{OWN}.evil.org", "http://localhost",
         f"http://user@{OWN}", f"HTTP://{OWN}", f"ws://{OWN}", OWN, f"http://localhost:{PORT}",
         "file://", f"http://{OWN}, http://{OWN}"]
    ),
    st.text(LATIN, max_size=40),
    HOSTS.map("http://{}".format),
)  # fmt: skip


def test_other_origins_are_refused(studio):
    found, run = studio

    @generated(CASES, origin=ORIGINS, is_socket=st.booleans())
    def refused(origin, is_socket):
        assume(origin != f"http://{OWN}")
        headers = [*headers_of(found.access, origin=False), (b"origin", origin.encode("latin-1"))]
        assert run(_status(found.app, headers, is_socket)) == 403

    refused()


def _changed(text):
    """Texts that are nearly this one."""
    places = st.integers(0, len(text) - 1)
    return st.one_of(
        st.just(""),
        places.map(lambda k: text[:k]),
        places.map(lambda k: text[:k] + text[k + 1 :]),
        places.map(lambda k: text[:k] + text[k].swapcase() + text[k + 1 :]),
        st.text(LATIN, min_size=1, max_size=4).map(lambda more: text + more),
        st.text(LATIN, max_size=60),
    )


def test_other_tokens_are_refused(studio):
    found, run = studio
    access = found.access
    begin = st.sampled_from(
        ["token=", "", "Token=", "token", "token=&token=", "a=1&token=", "?token="]
    )
    queries = st.one_of(
        st.tuples(begin, _changed(access.token)).map("".join),
        _changed(access.secret).map("token={}".format),
        st.just(f"token={access.secret}"),
        st.just(f"token={access.token}&x=1"),
        st.just(f"token={access.token}&token={access.token}"),
        st.text(LATIN, max_size=60),
    )

    @generated(CASES, query=queries, cookie=_changed(access.secret))
    def refused(query, cookie):
        assume(query.partition("&")[0] != f"token={access.token}" or "&" in query)
        assume(cookie.partition(";")[0].strip(" \t") != access.secret)
        headers = headers_of(access, cookie=False, origin=False)
        headers.append((b"cookie", f"{access.cookie_name}={cookie}".encode("latin-1")))
        answer = run(ask(found.app, "/", headers, query=query.encode("latin-1")))
        assert answer.status == 403
        assert "set-cookie" not in answer.headers
        assert answer.body.count(b"\n") == 1

    refused()


PARTS = st.one_of(
    st.sampled_from(
        ["", ".", "..", "...", "export", "thumb", "views", "texture", "scan", "live", "one", "A",
         "FULL", "secret.txt", "%2e%2e", "..%2f", "%00", "\\", "..\\", "~", "etc", "passwd", "C:",
         "studio.json", "painting", "style.png"]
    ),
    st.text(st.characters(exclude_categories=["Cs"]), max_size=8),
)  # fmt: skip
PATHS = st.lists(PARTS, max_size=6).map(lambda parts: "/" + "/".join(parts))
KNOWN = ("/", "/studio.js", "/studio.css", "/favicon.ico")


def test_no_path_leads_out_of_the_folders(studio):
    found, run = studio

    @generated(CASES, path=PATHS, method=st.sampled_from(["GET", "HEAD", "POST"]))
    def stays_inside(path, method):
        headers = headers_of(found.access)
        answer = run(ask(found.app, path, headers, method=method))
        assert SECRET.encode() not in answer.body
        if not (path in KNOWN or path.startswith("/thumb/")):
            assert answer.status in (404, 405)
            assert answer.body.count(b"\n") <= 1
        outside = headers_of(found.access, cookie=False)
        assert run(ask(found.app, path, outside, method=method)).status == 403

    stays_inside()


def test_exports_are_served_from_their_folder_alone(studio, tmp_path):
    found, run = studio
    exports = tmp_path / "painting" / "exports" / "003"
    assert run(found.get("/export/picture.png")).status == 404
    exports.mkdir(parents=True)
    (exports / "picture.png").write_bytes(b"picture")
    (exports / "link.txt").symlink_to(tmp_path / "secret.txt")
    (exports / "folder").mkdir()
    assert run(found.get("/export/picture.png")).body == b"picture"
    for name in ("link.txt", "folder", "..", "../style.png", "%2e%2e/style.png", "none.png"):
        assert run(found.get(f"/export/{name}")).status == 404


VALUES = st.recursive(
    st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=5)),
    lambda inner: st.one_of(
        st.lists(inner, max_size=3), st.dictionaries(st.text(max_size=5), inner, max_size=3)
    ),
    max_leaves=5,
)
TEXTS = st.one_of(
    st.text(max_size=30),
    VALUES.map(json.dumps),
    st.builds(
        lambda word, more: json.dumps({**more, "do": word}),
        st.one_of(st.sampled_from(list(protocol.WISHES)), st.text(max_size=5)),
        st.dictionaries(
            st.sampled_from(["serial", "name", "values", "step", "what", ""]), VALUES, max_size=3
        ),
    ),
    st.sampled_from(["[" * 20000, '{"do":' * 5000, "1" * 5000, '{"do": "seed", "value": NaN}',
                     '{"do": "look", "what": "\\ud800"} ', " " * 70000]),
)  # fmt: skip
U16 = st.one_of(st.integers(0, 40), st.integers(0, 65535))
FRAMES = st.one_of(
    st.binary(max_size=40),
    st.builds(
        lambda kind, zero, place, size, more: protocol._PAINT.pack(kind, zero, *place, *size, 1)
        + bytes(max(3 * (size[0] * size[1] % 4096) + more, 0)),
        st.sampled_from([1, 1, 1, 0, 2, 255]), st.sampled_from([0, 0, 0, 1]),
        st.tuples(U16, U16), st.tuples(U16, U16), st.sampled_from([0, 0, 0, 1, -1]),
    ),
)  # fmt: skip


def test_frames_that_no_page_sends_end_in_a_sentence(studio):
    found, run = studio

    def is_one_of_a_page(frame):
        try:
            parse_wish(frame) if isinstance(frame, str) else parse_paint(frame, found.desk.size)
        except ProtocolError:
            return False
        return True

    async def refused(frame):
        socket = found.socket()
        await socket.hello()
        socket.text(frame) if isinstance(frame, str) else socket.bytes(frame)
        texts = await socket.closed()
        return socket.code, texts[-1]

    @generated(CASES, frame=st.one_of(TEXTS, FRAMES))
    def closes(frame):
        assume(not is_one_of_a_page(frame))
        code, last = run(refused(frame))
        assert code in (1007, 1009)
        assert last["say"] == "problem"
        assert last["text"].isprintable()
        assert len(last["text"]) < 300

    closes()


@in_loop
async def test_a_page_of_another_version_is_told_to_reload(tmp_path):
    async with opened(tmp_path) as found:
        socket = found.socket()
        assert await socket.open()
        socket.say(do="hello", version=1)
        (problem,) = await socket.closed()
        assert "reload" in problem["text"]
        assert socket.code == 4000


@in_loop
async def test_whoever_says_no_hello_is_sent_away(tmp_path):
    async with opened(tmp_path) as found:
        socket = found.socket()
        assert await socket.open()
        socket.say(do="finish")
        await socket.closed()
        assert socket.code == 1007
        assert ("finish",) not in found.engine.calls


async def _status(app, headers, is_socket):
    if not is_socket:
        return (await ask(app, "/", headers)).status
    socket = Socket(app, headers)
    assert not await socket.open()
    return socket.status
