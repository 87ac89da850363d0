"""The hand, the brush, and what of it the server gets."""

import numpy as np
import pytest

pytestmark = pytest.mark.slow  # a browser is a process of its own


@pytest.fixture
def page(open_page, studio):
    page = open_page(studio).started()
    page.set("colour-number", "#c81e1e")
    page.set("size", 90)  # 15 pixels
    page.set("hardness", 100)
    page.set("smoothing", 0)
    return page


def test_a_stroke_appears_is_sent_and_changes_the_picture(page, studio):
    page.stroke((40, 60), (100, 60))
    shown = page.pixels()
    assert shown[60, 40:101].tolist() == [[200, 30, 30]] * 61
    assert np.array_equal(shown[:40], studio.beginning[:40])
    studio.rests(page.sent())
    assert studio.serial == len(studio.rectangles)
    assert np.array_equal(studio.painting, shown)
    page.until("document.getElementById('saved').textContent", "Saved")
    page.until("document.getElementById('which').textContent", "coherent")
    assert page.text("took") == "42 ms"
    picture = (
        "[...document.getElementById('picture').getContext('2d').getImageData(70, 60, 1, 1).data]"
    )
    page.until(picture, [55, 225, 225, 255])


def test_only_what_changed_is_sent(page, studio):
    page.stroke((40, 60), (60, 60))
    studio.rests(page.sent())
    for x, y, width, height, _ in studio.rectangles:
        assert 30 <= x <= 70 - width
        assert 50 <= y <= 70 - height


def test_undo_and_redo_restore_the_bytes(page, studio):
    before = page.pixels()
    page.stroke((10, 10), (150, 110))
    after = page.pixels()
    page.stroke((10, 110), (150, 10))
    page.page.keyboard.press("z")
    assert np.array_equal(page.pixels(), after)
    page.page.locator("#undo").click()
    assert np.array_equal(page.pixels(), before)
    assert page.page.locator("#undo").is_disabled()
    page.page.keyboard.press("Control+Shift+z")
    assert np.array_equal(page.pixels(), after)
    studio.rests(page.sent())
    assert np.array_equal(studio.painting, after)


def test_undo_keeps_to_its_memory_and_to_a_hundred_steps(page):
    kept = page.page.evaluate("""() => {
      const { constructor } = window.stylitStudio.artist.history;
      const small = new constructor(4 * 64 * 64 * 3);
      const large = new constructor();
      for (let k = 0; k < 105; k++)
        for (const history of [small, large]) history.add(new Map([[k, new Uint32Array(64 * 64)]]));
      return [small, large].map(({ bytes, undoable }) => [bytes, [...undoable[0].keys()][0]]);
    }""")
    assert kept == [[4 * 64 * 64 * 3, 102], [4 * 64 * 64 * 100, 5]]


def test_an_even_stroke_of_half_opacity(page, studio):
    page.set("opacity", 50)
    page.stroke((40, 60), (100, 60), (40, 60))
    expected = np.mean([studio.beginning[60, 60], (200, 30, 30)], 0)
    assert np.abs(page.pixels()[60, 60] - expected).max() <= 1


def test_a_texture_of_the_brush_leaves_ground_free(page, studio):
    page.set("grain", "paper")
    page.stroke((40, 60), (100, 60))
    painted = (page.pixels()[57:64, 45:96] == (200, 30, 30)).all(2).mean()
    assert 0.4 < painted < 0.9


def test_the_eyedropper_takes_a_colour_and_goes(page, studio):
    page.page.keyboard.press("i")
    page.page.mouse.click(*page.at(20, 30))
    expected = "#" + bytes(studio.beginning[30, 20]).hex()
    assert page.page.locator("#colour-number").input_value() == expected
    assert page.page.locator("[data-tool=brush][aria-pressed=true]").count() == 1
    assert page.text("said") == f"Picked {expected}."
    assert studio.rectangles == []


def test_the_eraser_brings_the_beginning_back_or_paper(page, studio):
    page.stroke((40, 60), (100, 60))
    page.page.keyboard.press("e")
    page.set("size", 130)  # 49 pixels: no soft rim of the stroke is left
    page.stroke((40, 60), (100, 60))
    assert np.array_equal(page.pixels(), studio.beginning)
    page.set("erases-to", "paper")
    page.stroke((40, 60), (100, 60))
    assert page.pixels()[60, 70].tolist() == [255, 255, 255]


def test_pressure_shapes_a_pen(page):
    page.page.evaluate(
        """([from, to]) => {
      const pane = document.getElementById("easel");
      pane.setPointerCapture = () => undefined; // no such pointer is down
      const send = (kind, [clientX, clientY], pressure) => pane.dispatchEvent(new PointerEvent(kind,
        { pointerId: 7, pointerType: "pen", clientX, clientY, pressure, bubbles: true }));
      send("pointerdown", from, 0.2);
      send("pointerrawupdate", to, 1);
      send("pointerup", to, 1);
    }""",
        [page.at(30, 60), page.at(120, 60)],
    )
    red = (page.pixels() == (200, 30, 30)).all(2).sum(0)
    assert 0 < red[32] < red[70] < red[110]


def test_keys_alone_paint(page, studio):
    keyboard = page.page.keyboard
    page.page.locator("#fit").focus()
    keyboard.press("Tab")
    while not page.page.evaluate("document.activeElement.id === 'easel'"):
        keyboard.press("Tab")
    keyboard.press("Shift+ArrowLeft")
    keyboard.press("Space")
    assert page.text("said").startswith("The brush is down.")
    for _ in range(10):
        keyboard.press("ArrowRight")
    keyboard.press("Escape")
    assert page.text("said") == "The brush is lifted."
    row = (page.pixels()[60] == (200, 30, 30)).all(1)
    assert row.sum() > 40
    studio.rests(page.sent())


def test_keys_choose_tools_and_shapes(page):
    chosen = "(({ tool, brush }) => [tool, brush.size, brush.opacity])"
    for key in "e[4":
        page.page.keyboard.press(key)
    assert page.page.evaluate(f"{chosen}(JSON.parse(localStorage['stylit-studio-tool']))") == [
        "eraser", 13, 0.4,
    ]  # fmt: skip
    page.page.keyboard.press("?")
    page.page.locator("#letters").uncheck()
    page.page.keyboard.press("Escape")
    page.page.keyboard.press("b")
    assert page.page.locator("[data-tool=eraser][aria-pressed=true]").count() == 1


def test_wheel_and_space_move_the_sheet_and_paint_nothing(page, studio):
    before = page.at(0, 0)
    page.page.mouse.move(*page.at(80, 60))
    page.page.mouse.wheel(0, -400)
    page.until("parseInt(document.getElementById('painting-zoom').textContent) > 300")
    assert page.at(0, 0)[0] < before[0]
    left = page.at(80, 60)[0]
    page.page.keyboard.down(" ")
    page.page.mouse.down()
    page.page.mouse.move(*[place + 30 for place in page.at(80, 60)])
    page.page.mouse.up()
    page.page.keyboard.up(" ")
    assert page.at(80, 60)[0] == pytest.approx(left + 30, abs=1)
    assert studio.rectangles == []
    page.page.keyboard.press("f")
    assert page.at(0, 0) == pytest.approx(before, abs=1)


def test_a_stroke_of_any_zoom_lies_where_the_hand_is(page):
    page.page.mouse.move(*page.at(40, 40))
    page.page.mouse.wheel(0, -600)
    page.page.evaluate("new Promise(requestAnimationFrame)")
    page.page.mouse.click(*page.at(42, 45))
    red = np.argwhere((page.pixels() == (200, 30, 30)).all(2))
    assert red.mean(0) == pytest.approx((45, 42), abs=0.5)


def test_a_picture_that_is_older_does_not_win(page, studio):
    page.stroke((40, 60), (100, 60))
    studio.rests(page.sent())
    page.until("document.getElementById('which').textContent", "coherent")
    late = studio.picture("fast", studio.painting)
    studio.say(late[:8] + b"\1\0\0\0" + late[12:])
    studio.say(studio.picture("full", studio.painting, 2345))
    page.until("document.getElementById('which').textContent", "full")
    assert page.text("took") == "2.3 s"


def test_how_long_replays_take_is_measured(page, studio):
    page.stroke((40, 60), (100, 60))
    page.until("window.stylitStudio.latency.times.some(({ which }) => which === 'coherent')")
    times = page.page.evaluate("window.stylitStudio.latency.times")
    assert {time["which"] for time in times} == {"replay", "coherent"}
    assert all(0 < time["milliseconds"] < 5000 for time in times)
