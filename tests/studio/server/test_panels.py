"""Parts of the page that a studio may have or not."""

import io
import json

import numpy as np
import pytest
from PIL import Image
from studio.server.opened import in_loop, opened
from studio.server.test_desk import several_sizes, stroke
from studio.small_studio import HEIGHT, SIZE, WIDTH, small_shelf

from stylit_ref import InputError, write_image
from stylit_ref.studio.painting.easel import LEAP
from stylit_ref.studio.server.dropped_texture import DroppedTexture
from stylit_ref.studio.server.scan_panel import scan_panel
from stylit_ref.studio.server.texture_panel import read_texture, texture_panel
from stylit_ref.studio.server.views_panel import views_panel
from stylit_ref.studio.sheet.layout import layout_of
from stylit_ref.studio.sheet.print_sheet import draw_sheet


@in_loop
async def test_views_are_shut_in_a_frame(tmp_path):
    async with opened(tmp_path, [views_panel(b"<p>caf\xe9")]) as found:
        assert (await found.socket().hello())["panels"] == ["views"]
        answer = await found.get("/views/")
        assert answer.body == b"<p>caf\xe9"
        assert answer.headers["content-type"] == "text/html; charset=windows-1252"
        policy = answer.headers["content-security-policy"]
        assert policy.startswith("sandbox allow-scripts allow-downloads; default-src 'none'; ")
        assert "allow-same-origin" not in policy


class NotedTexture:
    """Takes down what is dropped."""

    def __init__(self):
        self.exemplar = np.zeros((9, 9, 3), np.uint8)
        self.calls = []

    def picture(self):
        return np.ones((8, 8, 3), np.uint8)

    def dropped(self, source, place, *, keep):
        if source == (0, 0):
            raise InputError("source is too close to its border")
        self.calls.append((source, place, keep))
        return self.picture()

    def close(self):
        """End nothing."""


@in_loop
async def test_patches_are_dropped(tmp_path):
    texture = NotedTexture()
    async with opened(tmp_path, [texture_panel(texture)]) as found:
        assert (await found.get("/texture/exemplar")).body.startswith(b"\x89PNG")
        assert (await found.get("/texture/picture")).body.startswith(b"\x89PNG")
        _page, post = await found.page()
        asked = json.dumps({"from": [4, 5], "to": [1, 2], "keep": True}).encode()
        answer = await post("/texture/drop", asked)
        assert answer.headers["content-type"] == "image/png"
        assert texture.calls == [((4, 5), (1, 2), True)]
        asked = json.dumps({"from": [0, 0], "to": [1, 2], "keep": False}).encode()
        answer = await post("/texture/drop", asked)
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
        texture = NotedTexture()
        async with opened(tmp_path, [texture_panel(texture)]) as found:
            _page, post = await found.page()
            answer = await post("/texture/drop", body)
            assert answer.status == 400
            assert answer.body.count(b"\n") == 1
            assert texture.calls == []

    refused()


def test_a_dropped_patch_is_shown_and_stays_if_it_is_kept():
    exemplar = np.random.default_rng(0).integers(0, 256, (48, 48, 3), np.uint8)
    texture = DroppedTexture(exemplar, side=64, iterations=0)
    before = texture.picture()
    held = texture.dropped((24, 24), (10, 20), keep=False)
    assert np.array_equal(texture.picture(), before)
    assert np.array_equal(held[20, 10], exemplar[24, 24])
    dropped = texture.dropped((24, 24), (10, 20), keep=True)
    assert np.array_equal(dropped, held)
    assert np.array_equal(texture.picture(), held)
    with pytest.raises(InputError):
        texture.dropped((0, 0), (10, 20), keep=True)


@pytest.mark.slow
def test_a_texture_is_made_in_a_process_of_its_own(tmp_path):
    exemplar = np.random.default_rng(0).integers(0, 256, (48, 48, 3), np.uint8)
    write_image(tmp_path / "exemplar.png", exemplar)
    texture = read_texture(tmp_path / "exemplar.png")
    assert np.array_equal(texture.exemplar, exemplar)
    with pytest.raises(InputError, match="too close to its border"):
        texture.dropped((0, 0), (10, 20), keep=True)
    picture = texture.dropped((24, 24), (10, 20), keep=True)
    assert np.array_equal(picture[20, 10], exemplar[24, 24])
    assert np.array_equal(texture.picture(), picture)
    texture.close()
    with pytest.raises(InputError, match="begin another one"):
        texture.picture()


CORNERS = b'{"corners": [[20, 20], [270, 20], [270, 180], [20, 180]]}'
"""Of a picture in a photograph, as a page sends them."""


def png(image):
    """An image's file, as a page sends it."""
    content = io.BytesIO()
    image.save(content, format="PNG")
    return content.getvalue()


@in_loop
async def test_a_scan_becomes_the_painting(tmp_path):
    offer = small_shelf(tmp_path).first
    painting = np.full((*SIZE, 3), (250, 40, 90), np.uint8)
    layout = layout_of(WIDTH, HEIGHT)
    place = tuple((side - own) // 2 for side, own in zip((2480, 3508), layout, strict=True))
    painted = draw_sheet(offer.rendering(), offer.things()).convert("RGB")
    painted.paste(Image.fromarray(painting).resize(layout), place)
    async with opened(tmp_path, [scan_panel()]) as found:
        live, post = await found.page()
        pdf = await found.get("/sheet.pdf")
        assert pdf.headers["content-type"] == "application/pdf"
        assert pdf.body.startswith(b"%PDF")
        early = await post("/scan/corners", b'{"corners": [[0,0],[9,0],[9,9],[0,9]]}')
        assert (early.status, early.body) == (404, b"Send a photograph first.\n")
        small = painted.resize((1240, 1754))
        told = json.loads((await post("/scan", png(small))).body)
        assert (told["width"], told["height"]) == (1240, 1754)
        assert np.allclose(told["corners"][0], np.array(place) / 2, atol=2)
        assert told["text"] in (await live.said("notes"))["texts"][0]
        assert found.engine.calls[-1] == ("replace_painting", LEAP)
        assert np.abs(found.engine.painting[8:16, 8:24].astype(int) - painting[0, 0]).max() < 30


@in_loop
async def test_a_photograph_without_marks_waits_for_its_corners(tmp_path):
    photograph = Image.new("RGB", (300, 200), (200, 100, 50))
    async with opened(tmp_path, [scan_panel()]) as found:
        _page, post = await found.page()
        answer = await post("/scan", png(photograph))
        told = json.loads(answer.body)
        assert (answer.status, told["corners"]) == (200, None)
        assert "marks" in told["text"]
        wrong = await post("/scan/corners", b'{"corners": [[0,0],[0,0],[0,0],[0,0]]}')
        assert wrong.status == 400
        right = await post("/scan/corners", CORNERS)
        assert right.status == 200
        assert found.engine.calls[-1] == ("replace_painting", LEAP)


@in_loop
async def test_a_scan_is_refused_if_what_it_replaces_cannot_be_kept(tmp_path):
    async with opened(tmp_path, [scan_panel()]) as found:
        page, post = await found.page()
        page.bytes(stroke(1))
        await page.shown(1)
        (tmp_path / "painting").mkdir()
        (tmp_path / "painting" / "replaced").write_text("a file")
        await post("/scan", png(Image.new("RGB", (300, 200), (200, 100, 50))))
        answer = await post("/scan/corners", CORNERS)
        assert answer.status == 400
        assert answer.body.startswith(b"the painting stays, since it cannot be kept: ")
        assert found.engine.calls[-1][0] == "paint"


@in_loop
async def test_a_page_that_looks_on_can_neither_scan_nor_drop(tmp_path):
    panels = [scan_panel(), texture_panel(NotedTexture())]
    async with opened(tmp_path, panels) as found:
        painter, post = await found.page()
        reader, post_of_reader = await found.page()
        photograph = png(Image.new("RGB", (300, 200), (200, 100, 50)))
        for path, body in (
            ("/scan", photograph),
            ("/scan/corners", CORNERS),
            ("/texture/drop", b""),
        ):
            for refused in (found.post, post_of_reader):
                answer = await refused(path, body)
                assert (answer.status, answer.body) == (
                    403, b"This page looks on. Take over to paint here.\n",
                )  # fmt: skip
        reader.say(do="take_over")
        await painter.said("role")
        assert (await post("/scan", photograph)).status == 403
        assert (await post_of_reader("/scan", photograph)).status == 200


@in_loop
async def test_sheet_and_scan_are_those_of_the_scene_that_is_open(tmp_path):
    async with opened(tmp_path, [scan_panel()], several_sizes(tmp_path)) as found:
        page, post = await found.page()
        page.say(do="scene", name="three")
        await page.said("welcome")
        await post("/scan", png(Image.new("RGB", (300, 200), (200, 100, 50))))
        assert (await post("/scan/corners", CORNERS)).status == 200
        assert found.engine.painting.shape == (30, 40, 3)
        assert found.engine.calls[-1][0] == "replace_painting"


@pytest.mark.parametrize(
    "body",
    [b"", b"no photograph", b"\x89PNG\r\n\x1a\n" + bytes(50)],
    ids=["empty", "text", "damaged"],
)
def test_what_is_no_photograph_is_a_sentence(tmp_path, body):
    @in_loop
    async def refused():
        async with opened(tmp_path, [scan_panel()]) as found:
            _page, post = await found.page()
            answer = await post("/scan", body)
            assert answer.status == 400
            assert answer.body.startswith(b"the photograph: ")
            assert answer.body.endswith(b".\n")

    refused()
