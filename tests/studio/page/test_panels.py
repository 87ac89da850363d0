"""The thesis' window: what its controls ask for, and what they show."""

import numpy as np
import pytest

pytestmark = pytest.mark.slow  # a browser is a process of its own


@pytest.fixture
def page(open_page, studio):
    page = open_page(studio, size=(1300, 900)).started()
    page.unfold()
    return page


def test_the_target_is_chosen(page, studio):
    page.page.locator("#scene").select_option("teapot")
    assert studio.asks("scene") == {"do": "scene", "name": "teapot"}
    page.stroke((40, 60), (100, 60))
    assert np.array_equal(page.pixels(), studio.beginning)
    assert page.text("said") == "The scene is being opened; the brush waits for it."
    studio.say({**studio.welcome("painter"), "say": "scene", "scene": "teapot"})
    page.until("document.getElementById('turn-panel').hidden")
    assert page.page.locator("#guides input[type=checkbox]").count() == 0
    page.stroke((40, 60), (100, 60))
    assert not np.array_equal(page.pixels(), studio.beginning)


def test_the_target_is_turned_by_slider_drag_and_keys(page, studio):
    page.set("turn", 3)
    assert studio.asks("turn") == {"do": "turn", "step": 3, "restylize": True}
    page.page.locator("#turn-follows").uncheck()
    x, y = 900, 500
    page.page.mouse.move(x, y)
    page.page.mouse.down()
    page.page.mouse.move(x - 5 * 14, y)
    page.page.mouse.up()
    page.until("document.getElementById('turn').value", "10")
    page.page.locator("#target").focus()
    page.page.keyboard.press("ArrowRight")
    page.until("document.getElementById('turn-step').textContent", "12 of 12")
    page.page.locator("#turn-now").click()
    page.page.evaluate("new Promise(requestAnimationFrame)")
    page.page.evaluate("window.stylitStudio.session.parts.connection.ask({ do: 'finish' })")
    studio.asks("finish")
    turns = [(asked["step"], asked["restylize"]) for asked in studio.asked if asked["do"] == "turn"]
    assert turns[-2:] == [(11, False), (11, True)]


def test_looks_lie_over_the_pictures(page, studio):
    page.page.locator("#painting-look-choice").select_option("A:LDE")
    page.until("document.getElementById('painting-look').hidden", False)
    assert studio.asks("look") == {"do": "look", "what": "A:LDE"}
    page.page.locator("#picture-look-choice").select_option("level:2")
    page.until("document.getElementById('picture-look').hidden", False)
    assert page.text("picture-looked").split() == ["Level", "2", "Hide", "over"]
    page.set("picture-look-strength", 40)
    assert page.page.locator("#picture-look").evaluate("(it) => it.style.opacity") == "0.4"
    studio.say({"say": "problem", "text": "There is no level 2.", "of": "level:2"})
    page.until("document.getElementById('picture-looked').hidden")
    assert page.page.locator("#painting-look").is_visible()
    studio.asked.clear()
    page.stroke((40, 60), (60, 60))
    assert studio.asks("look") == {"do": "look", "what": "level:2"}
    page.page.locator("#painting-look-away").click()
    assert page.page.locator("#painting-look").is_hidden()
    assert page.page.locator("#painting-look-choice").input_value() == ""


def test_single_operations(page, studio):
    buttons = page.page.locator("#operations button")
    assert buttons.count() == 7
    page.page.get_by_role("button", name="Begin", exact=True).click()
    assert studio.asks("step") == {"do": "step", "operation": "restart"}
    page.until("document.getElementById('stepped').textContent", "Level 2, iteration 1.")
    assert page.page.locator("#operations button:enabled").all_text_contents() == [
        "Half iteration", "Blend",
    ]  # fmt: skip
    page.until("document.getElementById('which').textContent", "step")
    page.page.locator("#back").click()
    page.until("document.getElementById('which').textContent", "coherent")
    assert page.page.locator("#back").is_hidden()


def test_parameters_of_every_kind(page, studio):
    page.page.get_by_role("slider", name="levels L").evaluate(
        "(it) => { it.value = 5; it.dispatchEvent(new Event('input')); }"
    )
    assert studio.asks("parameters")["values"] == {"levels": 5}
    assert page.page.locator("#picture-look-choice option[value='level:4']").count() == 1
    studio.asked.clear()
    mu = page.page.get_by_role("group", name="style μ")
    mu.get_by_role("button", name="One level fewer for style μ").click()
    assert studio.asks("parameters")["values"] == {"mu": [4, 4]}
    studio.asked.clear()
    page.page.get_by_role("spinbutton", name="spacing r").fill("4")
    page.page.keyboard.press("Enter")
    assert studio.asks("parameters")["values"] == {"spacing": 4}
    studio.asked.clear()
    page.page.get_by_role("checkbox", name="labels").uncheck()
    assert studio.asks("parameters")["values"] == {"labels": False}
    studio.asked.clear()
    page.page.get_by_role("combobox", name="start").select_option("bilinear")
    assert studio.asks("parameters")["values"] == {"start": "bilinear"}


def test_dense_parameters_are_grey_in_live_mode(page):
    dense = page.page.get_by_role("slider", name="lambda")
    assert dense.is_disabled()
    page.page.locator("#of-dense").check(force=True)
    assert dense.is_enabled()
    assert page.page.get_by_role("slider", name="levels L").is_disabled()


def test_weights_layers_and_seed(page, studio):
    page.page.get_by_role("slider", name="Weight of FULL").evaluate(
        "(it) => { it.value = 7; it.dispatchEvent(new Event('input')); }"
    )
    assert studio.asks("weights") == {"do": "weights", "values": {"FULL": 7}}
    page.page.get_by_role("checkbox", name="NORMAL").check()
    assert studio.asks("layers") == {"do": "layers", "names": ["FULL", "LDE", "NORMAL"]}
    page.page.locator("#seed-next").click()
    assert studio.asks("seed") == {"do": "seed", "value": 6}
    for text, value in (("", 0), ("4294967295", 0), ("1.5", 0)):
        page.page.locator("#seed").evaluate("(it, text) => (it.value = text)", text)
        page.page.locator("#seed-next").click()
        page.until("document.getElementById('seed').value", str(value))


def test_an_export_shows_its_folder_and_commands(page, studio):
    page.page.locator("#export").click()
    page.until("document.getElementById('export-done').hidden", False)
    state = page.page.locator("#export-state").text_content()
    assert state == "The files lie in /oil/exports/001."
    assert page.page.locator("#export-commands code").text_content().startswith("stylit-ref run")
    link = page.page.locator("#export-files a")
    assert link.get_attribute("href") == "/export/picture.png"


def test_a_photograph_without_marks_has_corners_to_drag(page, studio, tmp_path):
    file = tmp_path / "sheet.png"
    file.write_bytes(page.page.screenshot(clip={"x": 0, "y": 0, "width": 400, "height": 300}))
    page.page.locator("#scan-file").set_input_files(file)
    page.until("document.getElementById('photo-frame').hidden", False)
    assert studio.photograph == file.read_bytes()
    box = page.page.locator("#photo").bounding_box()
    page.page.mouse.move(box["x"] + box["width"] * 0.1, box["y"] + box["height"] * 0.1)
    page.page.mouse.down()
    page.page.mouse.move(box["x"] + box["width"] / 4, box["y"] + box["height"] / 2)
    page.page.mouse.up()
    page.page.locator("#scan-send").click()
    corners = np.array(studio.asks("corners")["corners"])
    assert corners == pytest.approx(np.array([[10, 15], [36, 3], [36, 27], [4, 27]]), abs=0.2)
    page.until(
        "document.getElementById('scan-state').textContent", "The sheet is the painting now."
    )


def test_panels_of_rooms_that_are_missing_are_absent(page):
    assert page.page.locator("#paper-panel").is_visible()
    assert page.page.locator("#texture-panel").is_hidden()
    assert page.page.locator("#views-panel").is_hidden()


def test_a_patch_is_dragged_onto_a_texture_that_the_brush_paints_with(open_page, make_studio):
    studio = make_studio(panels=("texture", "views"))
    page = open_page(studio, size=(1300, 900)).started()
    page.page.locator("#texture-panel summary").click()
    page.until("document.getElementById('texture').width", 32)
    assert page.page.locator("#views-panel").is_visible()
    exemplar = page.page.locator("#exemplar").bounding_box()
    texture = page.page.locator("#texture").bounding_box()
    page.page.mouse.move(exemplar["x"] + exemplar["width"] / 4, exemplar["y"] + 4)
    page.page.mouse.down()
    page.page.mouse.move(texture["x"] + texture["width"] / 2, texture["y"] + 6, steps=3)
    page.page.mouse.up()
    page.until("window.stylitStudio.session.parts.texture.isAsking", False)
    drop = studio.asks("drop")
    assert (drop["from"][0], drop["to"][0], drop["keep"]) == (4, 16, True)
    page.page.locator("#paints-texture").check()
    page.stroke((40, 60), (100, 60))
    assert page.pixels()[60, 66].tolist() == [30, 160, 90]
