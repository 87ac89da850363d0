"""Windows of every width, touch, and people who need more than eyes and a mouse."""

from pathlib import Path

import numpy as np
import pytest

pytestmark = pytest.mark.slow  # a browser is a process of its own

AXE = Path(__file__).parents[3] / "node_modules/axe-core/axe.min.js"
CUT = """() => [...document.querySelectorAll("button, select, input, canvas.look, output")]
  .filter((it) => it.checkVisibility() && !it.closest("#panels, #recent"))
  .filter((it) => {
    const { left, right, top, bottom } = it.getBoundingClientRect();
    return left < 0 || top < 0 || right > innerWidth || bottom > innerHeight;
  })
  .map((it) => it.id || it.ariaLabel)"""


@pytest.mark.parametrize("size", [(360, 640), (390, 844), (740, 360), (820, 1180), (1400, 900)])
def test_nothing_is_cut_and_both_pictures_are_seen(open_page, studio, size):
    page = open_page(studio, size=size).started()
    assert page.page.evaluate("document.documentElement.scrollWidth") == size[0]
    assert page.page.evaluate(CUT) == []
    for name in ("painting", "picture"):
        box = page.page.locator(f"#{name}").bounding_box()
        assert box["width"] * box["height"] > 0.08 * size[0] * size[1]
        assert 0 <= box["x"] <= size[0] - box["width"]


def test_a_finger_paints_and_two_fingers_zoom(open_page, studio):
    page = open_page(studio, size=(390, 844), has_touch=True, is_mobile=True).started()
    touch = page.page.context.new_cdp_session(page.page)

    def fingers(kind, *places):
        points = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(places)]
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    page.set("colour-number", "#c81e1e")
    fingers("touchStart", page.at(40, 60))
    fingers("touchMove", page.at(60, 60))
    fingers("touchMove", page.at(100, 60))
    fingers("touchEnd")
    assert page.pixels()[60, 70].tolist() == [200, 30, 30]
    studio.rests(page.sent())

    painted = page.pixels()
    one, other = page.at(60, 50), page.at(100, 70)
    fingers("touchStart", one)
    fingers("touchStart", one, other)
    fingers("touchMove", (one[0] - 40, one[1] - 20), (other[0] + 40, other[1] + 20))
    fingers("touchEnd")
    page.until("parseInt(document.getElementById('painting-zoom').textContent) > 300")
    assert np.array_equal(page.pixels(), painted)


def test_sheets_of_a_phone_open_and_close_and_notices_take_turns(open_page, studio):
    page = open_page(studio, size=(390, 844), has_touch=True, is_mobile=True).started()
    for text in ("The target cannot be read.", "The painting is not saved."):
        studio.say({"say": "problem", "text": text})
    problems = page.page.locator("#problems p")
    page.until("document.querySelectorAll('#problems p').length", 2)
    assert [problems.nth(k).is_visible() for k in range(2)] == [False, True]
    problems.nth(1).get_by_role("button").tap()
    assert problems.is_visible()
    problems.get_by_role("button").tap()
    assert page.page.locator("#size").is_hidden()
    page.page.locator("#brush-open").tap()
    assert page.page.locator("#size").is_visible()
    page.page.locator("#colour").tap()
    assert page.page.locator("#size").is_hidden()
    assert page.page.locator("#hue").is_visible()
    page.page.keyboard.press("Escape")
    assert page.page.locator("#hue").is_hidden()
    page.page.locator("#panels-open").tap()
    assert page.page.locator("#turn").is_visible()
    boxes = [page.page.locator(f"#{name}").bounding_box() for name in ("picture", "panels")]
    assert boxes[0]["y"] + boxes[0]["height"] <= boxes[1]["y"]
    page.page.locator("#panels-close").tap()
    assert page.page.locator("#turn").is_hidden()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing(open_page, make_studio, scheme):
    if not AXE.exists():
        pytest.skip("axe-core is not installed; run make bundles")
    studio = make_studio(panels=("texture", "views"))
    # What is tested is the page; its policy would not let the tester in.
    settings = {"color_scheme": scheme, "bypass_csp": True, "reduced_motion": "reduce"}
    page = open_page(studio, size=(1400, 900), **settings).started()
    page.page.add_script_tag(path=AXE)
    page.unfold()
    page.page.locator("#colour").click()
    studio.say({"say": "problem", "text": "The target cannot be read."})
    studio.say({"say": "role", "role": "reader"})
    page.until("document.getElementById('banner').hidden", False)
    assert _violations(page) == []
    for opener in ("help", "panels-open"):
        page.page.locator(f"#{opener}").click()
        assert _violations(page) == []
        page.page.keyboard.press("Escape")


def test_rings_show_where_keys_go(open_page, studio):
    page = open_page(studio).started()
    page.page.keyboard.press("Tab")
    for name in ("scene", "finish", "export", "help"):
        focused = page.page.evaluate(
            "[document.activeElement.id, getComputedStyle(document.activeElement).outlineStyle]"
        )
        assert focused == [name, "solid"]
        page.page.keyboard.press("Tab")


def _violations(page):
    return page.page.evaluate(
        "async () => (await axe.run()).violations.map(({ id, nodes }) =>"
        " [id, nodes.map(({ html }) => html.slice(0, 120))])"
    )
