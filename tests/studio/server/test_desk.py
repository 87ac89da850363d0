"""Pages at one desk: who paints, what the others see, what comes back after a restart."""

import asyncio
import gc
import struct
import tracemalloc

import numpy as np
import pytest
from hostile.generated import generated
from hypothesis import strategies as st
from studio.server.opened import in_loop, opened
from studio.small_studio import (
    HEIGHT,
    SIZE,
    TARGET_SIZE,
    WIDTH,
    small_beginning,
    small_shelf,
    write_passes,
)

from stylit_ref import InputError, read_image, write_image
from stylit_ref.studio.engine.events import Compiling, Picture, Problem, Working
from stylit_ref.studio.painting.easel import LEAP
from stylit_ref.studio.painting.folder import PaintingFolder
from stylit_ref.studio.painting.paint_file import read_paint
from stylit_ref.studio.scene_files.offer import offer_of_files
from stylit_ref.studio.scene_files.shelf import Shelf
from stylit_ref.studio.server import beginning as beginning_module
from stylit_ref.studio.server.beginning import begin
from stylit_ref.studio.server.protocol import parse_paint


def stroke(serial, x=3, y=4, colour=200, size=(2, 5)):
    """A rectangle of one colour, as a page sends it."""
    height, width = size
    return struct.pack("<BBHHHHI", 1, 0, x, y, width, height, serial) + bytes(
        [colour] * (3 * width * height)
    )


def image_of(message):
    """(image, serial) of what a page is shown."""
    width, height, _, serial, _ = struct.unpack_from("<HHHIf", message, 2)
    return np.frombuffer(message, np.uint8, offset=16).reshape(height, width, 3), serial


@in_loop
async def test_the_welcome_says_all_that_the_page_shows(tmp_path):
    async with opened(tmp_path) as found:
        welcome = await found.socket().hello()
        assert welcome["role"] == "painter"
        assert welcome["painting"] == {
            "width": WIDTH, "height": HEIGHT, "name": str(tmp_path / "painting"), "serial": 0,
        }  # fmt: skip
        assert [scene["name"] for scene in welcome["scenes"]] == ["one", "two"]
        assert welcome["scenes"][0]["buffers"] == ["FULL", "IDMASK", "LDE"]
        assert (welcome["scenes"][0]["width"], welcome["scenes"][0]["height"]) == (28, 20)
        assert (welcome["scene"], welcome["step"], welcome["seed"]) == ("one", 0, 0)
        names = [field["name"] for field in welcome["parameters"]["fields"]]
        assert set(names) == set(welcome["parameters"]["values"])


@in_loop
async def test_a_stroke_reaches_the_engine_and_its_picture_the_page(tmp_path):
    async with opened(tmp_path) as found:
        page = found.socket()
        await page.hello()
        beginning, serial = image_of(await page.shown(2))
        assert serial == 0
        assert np.array_equal(beginning, read_image(tmp_path / "source" / "FULL.png"))
        page.bytes(stroke(7))
        picture, serial = image_of(await page.shown(1))
        assert serial == 7
        assert (picture[4:6, 3:8] == 200).all()
        assert found.engine.calls[-1] == ("paint", 3, 4, (2, 5), 7)


@in_loop
async def test_the_second_page_reads_until_it_takes_over(tmp_path):
    async with opened(tmp_path) as found:
        first, second = found.socket(), found.socket()
        await first.hello()
        assert (await second.hello())["role"] == "reader"
        second.bytes(stroke(1))
        assert "Take over" in (await second.said("problem"))["text"]
        first.bytes(stroke(2))
        shown = 0
        while shown != 2:  # the one that the socket began with comes first
            image, shown = image_of(await second.shown(2))
        assert (image[4:6, 3:8] == 200).all()
        second.say(do="take_over")
        assert (await first.said("role"))["role"] == "reader"
        assert (await second.said("role"))["role"] == "painter"
        first.say(do="finish")
        assert "Take over" in (await first.said("problem"))["text"]
        assert ("finish",) not in found.engine.calls
        second.say(do="finish")
        second.say(do="rest", serial=2)
        await second.said("saved")
        assert ("finish",) in found.engine.calls


@in_loop
async def test_the_place_of_a_painter_who_left_is_free(tmp_path):
    async with opened(tmp_path) as found:
        first, reader = found.socket(), found.socket()
        await first.hello()
        await reader.hello()
        await first.leave()
        assert (await reader.said("notes"))["texts"] == [
            "Nobody paints now. Take over to paint here."
        ]
        assert (await found.socket().hello())["role"] == "painter"


@in_loop
async def test_a_page_that_comes_later_sees_the_last_picture_and_what_went_wrong(tmp_path):
    async with opened(tmp_path) as found:
        found.engine.tell(Problem("before anybody came"))
        first = found.socket()
        await first.hello()
        assert (await first.said("problem"))["text"] == "before anybody came."
        found.engine.tell(Compiling("compiles", 1, 3))
        first.bytes(stroke(1))
        await first.shown(1)
        found.engine.tell(Problem("since the picture"))
        second = found.socket()
        await second.hello()
        assert (await second.said("compiling"))["total"] == 3
        assert (await second.said("problem"))["text"] == "since the picture."
        assert image_of(await second.shown(1))[1] == 1


@in_loop
async def test_looks_are_for_the_painter(tmp_path):
    async with opened(tmp_path) as found:
        first, second = found.socket(), found.socket()
        await first.hello()
        await second.hello()
        for of in ("nnf", "A:FULL"):
            found.engine.tell(Picture("look", np.zeros((2, 3, 3), np.uint8), 1, 1.5, of))
        found.engine.show("fast", 2)
        for of in (b"nnf", b"A:FULL"):
            look = await first.shown(1)
            assert (look[1], look[16 : 16 + len(of)]) == (6, of)
        assert (await second.shown(1))[1] == 3


@in_loop
async def test_a_slow_page_gets_the_newest_picture_alone(tmp_path):
    async with opened(tmp_path) as found:
        page = found.socket()
        await page.hello()
        for serial in range(1, 30):
            found.engine.show("replay", serial)
        found.engine.tell(Working("fast", "started", ""))
        await page.said("working")
        assert image_of(await page.shown(1))[1] == 29


@in_loop
async def test_wishes_reach_the_engine(tmp_path):
    async with opened(tmp_path) as found:
        page = found.socket()
        await page.hello()
        page.say(do="parameters", values={"levels": 3})
        page.say(do="weights", values={"LDE": 2})
        page.say(do="seed", value=5)
        page.say(do="step", operation="half")
        page.say(do="look", what="nnf")
        page.say(do="export")
        page.say(do="scene", name="two")
        chosen = await page.said("scene")
        assert chosen["scene"] == "two"
        assert chosen["parameters"]["values"]["levels"] == 3
        page.say(do="layers", names=["FULL"])
        assert (await page.said("scene"))["layers"] == ["FULL"]
        page.say(do="turn", step=1, restylize=True)
        assert "steps" in (await page.said("problem"))["text"]
        names = [name for name, *_ in found.engine.calls]
        assert names == ["begin", "set_parameters", "set_weights", "set_seed", "step", "look",
                         "export", "choose_scene", "choose_scene"]  # fmt: skip
        assert found.engine.calls[3] == ("set_seed", 5)
        assert found.engine.calls[6][1]() == tmp_path / "painting" / "exports" / "001"
        assert found.engine.calls[-1][1].buffers == ("FULL",)


@in_loop
async def test_what_the_engine_refuses_is_a_sentence(tmp_path):
    async with opened(tmp_path) as found:

        def refuse(values):
            raise InputError("is 0; it must be an integer from 1 to 12", parameter="levels")

        found.engine.set_parameters = refuse
        page = found.socket()
        await page.hello()
        page.say(do="parameters", values={"levels": 0})
        text = (await page.said("problem"))["text"]
        assert text == "levels is 0; it must be an integer from 1 to 12."
        assert (await page.said("scene"))["parameters"]["values"]["levels"] == 6
        page.say(do="scene", name="three")
        assert "no scene 'three'" in (await page.said("problem"))["text"]


@in_loop
async def test_a_restart_brings_all_back(tmp_path):
    async with opened(tmp_path) as found:
        page = found.socket()
        await page.hello()
        page.say(do="scene", name="two")
        page.say(do="parameters", values={"mu": [3, 0]})
        page.say(do="weights", values={"LDE": 2})
        page.say(do="seed", value=9)
        page.bytes(stroke(41))
        await page.shown(1)
        painting = found.engine.painting.copy()
    async with opened(tmp_path, beginning=small_beginning(tmp_path)) as found:
        page = found.socket()
        welcome = await page.hello()
        assert (welcome["scene"], welcome["seed"]) == ("two", 9)
        assert welcome["painting"]["serial"] == 41
        assert welcome["parameters"]["values"]["mu"] == [3, 0]
        assert welcome["weights"] == {"LDE": 2}
        assert welcome["notes"][0].startswith(f"The painting in {tmp_path / 'painting'} is back")
        beginning, serial = image_of(await page.shown(2))
        assert serial == 0
        assert np.array_equal(beginning, read_image(tmp_path / "source" / "FULL.png"))
        back, serial = image_of(await page.shown(2))
        assert serial == 41
        assert np.array_equal(back, painting)
        assert found.engine.calls[0] == ("begin", "two", 9)
        page.bytes(stroke(42, 0, 0, 7, SIZE))  # it has painted more than was saved
        assert (image_of(await page.shown(1))[0] == 7).all()


@in_loop
async def test_a_setting_of_another_version_is_left_out_and_told(tmp_path):
    (tmp_path / "painting").mkdir()
    write_image(tmp_path / "painting" / "style.png", np.zeros((*SIZE, 3), np.uint8))
    (tmp_path / "painting" / "studio.json").write_text('{"version": 1, "scene": "gone"}')
    async with opened(tmp_path) as found:
        notes = (await found.socket().hello())["notes"]
        assert "there is no scene 'gone'" in notes[0]
        assert found.engine.calls[0] == ("begin", "one", 0)


def several_sizes(folder):
    """The scenes ``one`` and ``two``, and ``three``, whose source is larger."""
    write_passes(folder / "large", (30, 40))
    write_passes(folder / "three", TARGET_SIZE, seed=3)
    offers = list(small_shelf(folder))
    offers.append(offer_of_files("three", folder / "large", folder / "three"))
    return begin(Shelf(offers), PaintingFolder(folder / "painting"))


@in_loop
async def test_scenes_of_several_sizes_have_a_painting_each(tmp_path):
    async with opened(tmp_path, beginning=several_sizes(tmp_path)) as found:
        page = found.socket()
        await page.hello()
        page.bytes(stroke(1))
        page.say(do="scene", name="three")
        welcome = await page.said("welcome")
        assert (welcome["painting"]["width"], welcome["painting"]["height"]) == (40, 30)
        assert welcome["painting"]["name"] == str(tmp_path / "painting")
        assert found.engine.calls[-1][1].size == (30, 40)
        serial = welcome["painting"]["serial"] + 1
        page.bytes(stroke(serial, 30, 20))
        page.say(do="scene", name="two")
        assert (await page.said("welcome"))["painting"]["serial"] == serial + LEAP
        while (shown := image_of(await page.shown(2)))[1] != serial + LEAP:
            pass
        assert (shown[0][4:6, 3:8] == 200).all()
        page.say(do="scene", name="three")
        await page.said("welcome")
    async with opened(tmp_path, beginning=several_sizes(tmp_path)) as found:
        welcome = await found.socket().hello()
        assert welcome["scene"] == "three"
        assert (found.engine.painting[20:22, 30:35] == 200).all()
    painting = read_image(tmp_path / "painting" / "style.png")
    assert (painting[4:6, 3:8] == 200).all()


@in_loop
async def test_a_painting_that_cannot_be_had_leaves_this_one_which_is_saved(tmp_path):
    beginning = several_sizes(tmp_path)
    write_image(tmp_path / "painting" / "40x30" / "style.png", np.zeros((9, 9, 3), np.uint8))
    async with opened(tmp_path, beginning=beginning) as found:
        page = found.socket()
        await page.hello()
        page.say(do="scene", name="three")
        assert "is 9x9, but the painting is 40x30" in (await page.said("problem"))["text"]
        assert (await page.said("scene"))["scene"] == "one"
        page.bytes(stroke(1))
        page.say(do="rest", serial=1)
        await page.said("saved")
        assert (read_image(tmp_path / "painting" / "style.png")[4:6, 3:8] == 200).all()


@in_loop
async def test_strokes_on_their_way_do_not_land_on_the_painting_of_another_scene(tmp_path):
    async with opened(tmp_path, beginning=several_sizes(tmp_path)) as found:
        page = found.socket()
        await page.hello()
        page.bytes(stroke(1))
        page.say(do="scene", name="three")
        page.bytes(stroke(2))
        serial = (await page.said("welcome"))["painting"]["serial"]
        page.bytes(stroke(serial + 1, 34, 10))
        page.say(do="scene", name="two")
        page.bytes(stroke(serial + 2, 34, 10))
        last = (await page.said("welcome"))["painting"]["serial"] + 1
        page.bytes(stroke(last, 20, 10))
        while image_of(await page.shown(1))[1] != last:
            pass
        painted = [call[-1] for call in found.engine.calls if call[0] == "paint"]
        assert painted == [1, serial + 1, last]


@in_loop
async def test_whoever_takes_over_while_a_scene_is_opened_paints_on_its_painting(tmp_path):
    async with opened(tmp_path, beginning=several_sizes(tmp_path)) as found:
        first, second = found.socket(), found.socket()
        await first.hello()
        await second.hello()
        first.say(do="scene", name="three")
        second.say(do="take_over")
        assert (await second.said("welcome"))["painting"]["width"] == 40
        assert (await second.said("role"))["role"] == "painter"
        painting = (await second.said("welcome"))["painting"]
        assert painting["width"] == 40
        second.bytes(stroke(painting["serial"] + 1, 30, 20))
        while image_of(await second.shown(1))[1] != painting["serial"] + 1:
            pass
        assert found.engine.calls[-1][0] == "paint"


@in_loop
async def test_what_cannot_be_saved_in_the_end_is_an_error(tmp_path):
    async with opened(tmp_path) as found:
        page = found.socket()
        await page.hello()
        page.bytes(stroke(1))
        await page.shown(1)
        (tmp_path / "painting").write_text("a file")
        with pytest.raises(InputError, match="painting"):
            await asyncio.to_thread(found.desk.close)
        assert found.engine.calls[-1] == ("close",)
        (tmp_path / "painting").unlink()
    assert (read_image(tmp_path / "painting" / "style.png")[4:6, 3:8] == 200).all()


def test_a_style_does_not_replace_a_painting(tmp_path):
    painting = np.full((*SIZE, 3), 5, np.uint8)
    write_image(tmp_path / "oil.png", painting)
    beginning = small_beginning(tmp_path, style=tmp_path / "oil.png")
    assert np.array_equal(beginning.saved.painting, painting)
    beginning.folder.save(beginning.saved)
    with pytest.raises(InputError, match="holds a painting"):
        small_beginning(tmp_path, style=tmp_path / "oil.png")


@in_loop
async def test_a_replaced_painting_is_kept(tmp_path):
    async with opened(tmp_path) as found:
        page = found.socket()
        await page.hello()
        page.bytes(stroke(3))
        painted = image_of(await page.shown(1))[0]
        found.desk.replace_painting(np.full((*SIZE, 3), 9, np.uint8), "Watched.")
        kept = (await page.said("notes"))["texts"][0]
        image, serial = image_of(await page.shown(2))
        while serial != 3 + LEAP:
            image, serial = image_of(await page.shown(2))
        assert (image == 9).all()
        assert found.engine.calls[-1] == ("replace_painting", 3 + LEAP)
        file = tmp_path / "painting" / "replaced" / "style_001.png"
        assert str(file) in kept
        assert np.array_equal(read_image(file), painted)


@in_loop
async def test_a_painting_of_last_time_is_kept_too(tmp_path):
    async with opened(tmp_path) as found:
        page = found.socket()
        await page.hello()
        page.bytes(stroke(3))
        await page.shown(1)
    async with opened(tmp_path) as found:
        found.desk.replace_painting(np.full((*SIZE, 3), 9, np.uint8), "Scanned.")
        kept = read_image(tmp_path / "painting" / "replaced" / "style_001.png")
        assert (kept[4:6, 3:8] == 200).all()
        found.desk.replace_painting(np.full((*SIZE, 3), 8, np.uint8), "Scanned.")
        assert len(list((tmp_path / "painting" / "replaced").iterdir())) == 1


def test_a_watched_file_that_is_another_one_is_saved_at_once(tmp_path):
    painting = np.full((*SIZE, 3), 5, np.uint8)
    beginning = small_beginning(tmp_path)
    beginning.folder.save(beginning.saved)
    write_image(tmp_path / "krita.png", painting)
    for _ in range(2):
        notes = small_beginning(tmp_path, watched=tmp_path / "krita.png").notes
    assert "is back" in notes[-1]
    assert np.array_equal(read_image(tmp_path / "painting" / "style.png"), painting)
    kept = tmp_path / "painting" / "replaced"
    assert [file.name for file in kept.iterdir()] == ["style_001.png"]


def test_a_watched_file_that_is_saved_while_the_studio_starts_is_seen(tmp_path, monkeypatch):
    before, after = (np.full((*SIZE, 3), value, np.uint8) for value in (6, 7))
    write_image(tmp_path / "krita.png", before)

    def read_and_save(file, size):
        painting = read_paint(file, size)
        write_image(file, after)
        return painting

    monkeypatch.setattr(beginning_module, "read_paint", read_and_save)
    beginning = small_beginning(tmp_path, watched=tmp_path / "krita.png")
    assert np.array_equal(beginning.saved.painting, before)
    assert beginning.watch.look() is None  # it may be written still
    assert np.array_equal(beginning.watch.look(), after)


@in_loop
async def test_an_evening_of_strokes_leaves_no_memory_behind(tmp_path):
    async with opened(tmp_path) as found:
        page = found.socket()
        await page.hello()

        async def paint(serials):
            for serial in serials:
                page.bytes(stroke(serial, serial % 20, serial % 15))
                page.say(do="rest", serial=serial)
                await page.shown(1)
                found.engine.calls.clear()
            gc.collect()
            return tracemalloc.get_traced_memory()[0]

        tracemalloc.start()
        try:
            before = await paint(range(1, 200))
            after = await paint(range(200, 1200))
        finally:
            tracemalloc.stop()
        assert after - before < 2 * SIZE[0] * SIZE[1] * 3 + 50_000  # two paintings, at most


@in_loop
async def test_thumbnails(tmp_path):
    async with opened(tmp_path) as found:
        for path in ("one/A/FULL", "two/B/IDMASK"):
            answer = await found.get(f"/thumb/{path}")
            assert (answer.status, answer.headers["content-type"]) == (200, "image/png")
            assert answer.body.startswith(b"\x89PNG")
        for path in ("one/C/FULL", "three/A/FULL", "one/A/NONE", "one/A/../../secret"):
            answer = await found.get(f"/thumb/{path}")
            assert (answer.status, answer.body.count(b"\n")) == (404, 1)


@generated(
    300, x=st.integers(0, WIDTH - 1), y=st.integers(0, HEIGHT - 1),
    size=st.tuples(st.integers(1, HEIGHT), st.integers(1, WIDTH)), serial=st.integers(0, 2**32 - 1),
)  # fmt: skip
def test_rectangles_within_the_painting_are_read(x, y, size, serial):
    height, width = min(size[0], HEIGHT - y), min(size[1], WIDTH - x)
    paint = parse_paint(stroke(serial, x, y, 4, (height, width)), SIZE)
    assert (paint.x, paint.y, paint.serial) == (x, y, serial)
    assert paint.pixels.shape == (height, width, 3)
