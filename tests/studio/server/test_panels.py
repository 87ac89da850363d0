"""Parts of the page that a studio may have or not."""

import json

import numpy as np
import pytest
from studio.server.opened import in_loop, opened

from stylit_ref import InputError
from stylit_ref.studio.server.texture_panel import DroppedTexture, texture_panel
from stylit_ref.studio.server.views_panel import views_panel


@in_loop
async def test_views_are_shut_in_a_frame(tmp_path):
    made = []

    def page():
        made.append(1)
        return "<p>caf\xe9".encode("latin-1")

    async with opened(tmp_path, [views_panel(page)]) as found:
        assert (await found.socket().hello())["panels"] == ["views"]
        for _ in range(2):
            answer = await found.get("/views/")
            assert answer.body == b"<p>caf\xe9"
        assert answer.headers["content-type"] == "text/html; charset=windows-1252"
        policy = answer.headers["content-security-policy"]
        assert policy.startswith("sandbox allow-scripts allow-downloads; default-src 'none'; ")
        assert "allow-same-origin" not in policy
        assert made == [1]


@in_loop
async def test_views_that_cannot_be_shown_are_a_sentence(tmp_path):
    def page():
        raise InputError("run: has no views")

    async with opened(tmp_path, [views_panel(page)]) as found:
        answer = await found.get("/views/")
        assert (answer.status, answer.body) == (404, b"run: has no views.\n")


class Texture(DroppedTexture):
    """Takes down what is dropped."""

    def __init__(self):
        self.exemplar = np.zeros((9, 9, 3), np.uint8)
        self.calls = []

    picture = np.ones((8, 8, 3), np.uint8)

    def dropped(self, source, place, *, keep):
        if source == (0, 0):
            raise InputError("source is too close to its border")
        self.calls.append((source, place, keep))
        return self.picture


@in_loop
async def test_patches_are_dropped(tmp_path):
    texture = Texture()
    async with opened(tmp_path, [texture_panel(texture)]) as found:
        assert (await found.get("/texture/exemplar")).body.startswith(b"\x89PNG")
        assert (await found.get("/texture/picture")).body.startswith(b"\x89PNG")
        asked = json.dumps({"from": [4, 5], "to": [1, 2], "keep": True}).encode()
        answer = await found.post("/texture/drop", asked)
        assert answer.headers["content-type"] == "image/png"
        assert texture.calls == [((4, 5), (1, 2), True)]
        asked = json.dumps({"from": [0, 0], "to": [1, 2], "keep": False}).encode()
        answer = await found.post("/texture/drop", asked)
        assert (answer.status, answer.body) == (400, b"source is too close to its border.\n")


@pytest.mark.parametrize(
    "body",
    [b"", b"[]", b"{}", b"[" * 5000, b'{"from": [1, 2], "to": [1], "keep": true}',
     b'{"from": [1, "2"], "to": [1, 2], "keep": true}', b'{"from": [1, 2], "to": [1, 2]}',
     b'{"from": [1, NaN], "to": [1, 2], "keep": true}',
     b'{"from": [1, 1e999], "to": [1, 2], "keep": true}'],
)  # fmt: skip
def test_bodies_that_no_page_sends_are_a_sentence(tmp_path, body):
    @in_loop
    async def refused():
        texture = Texture()
        async with opened(tmp_path, [texture_panel(texture)]) as found:
            answer = await found.post("/texture/drop", body)
            assert answer.status == 400
            assert answer.body.count(b"\n") == 1
            assert texture.calls == []

    refused()


def test_a_dropped_patch_is_shown_and_stays_if_it_is_kept():
    exemplar = np.random.default_rng(0).integers(0, 256, (48, 48, 3), np.uint8)
    texture = DroppedTexture(exemplar, side=64, iterations=0)
    before = texture.picture.copy()
    held = texture.dropped((24, 24), (10, 20), keep=False)
    assert np.array_equal(texture.picture, before)
    assert np.array_equal(held[20, 10], exemplar[24, 24])
    dropped = texture.dropped((24, 24), (10, 20), keep=True)
    assert np.array_equal(dropped, held)
    assert np.array_equal(texture.picture, held)
    with pytest.raises(InputError):
        texture.dropped((0, 0), (10, 20), keep=True)
