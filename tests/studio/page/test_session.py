"""Reloads, second tabs, servers that go and come, and what the page says of it."""

import numpy as np
import pytest

from stylit_ref.studio.engine.events import Picture
from stylit_ref.studio.server.sent_picture import SentPicture

pytestmark = pytest.mark.slow  # a browser is a process of its own

LINE = "document.getElementById('banner').textContent"


def test_a_reload_brings_the_painting_back(open_page, studio):
    page = open_page(studio).started()
    page.stroke((40, 60), (100, 60))
    studio.rests(page.sent())
    painted = page.pixels()
    page.page.reload()
    page.started()
    page.until("window.stylitStudio.sender.serial", studio.serial)
    assert np.array_equal(page.pixels(), painted)
    page.page.keyboard.press("e")
    page.set("size", 130)  # no soft rim of the stroke is left
    page.stroke((40, 60), (100, 60))
    assert np.array_equal(page.pixels(), studio.beginning)


def test_a_second_tab_looks_on_until_it_takes_over(open_page, studio):
    first = open_page(studio).started()
    second = open_page(studio, context=first.page.context).started()
    second.until(f"{LINE}.startsWith('Another page has the brush; this one looks on.')")
    second.stroke((20, 20), (60, 20))
    assert np.array_equal(second.pixels(), studio.beginning)
    for name in ("finish", "colour", "size"):
        assert second.page.locator(f"#{name}").is_disabled()
    assert second.page.get_by_role("button", name="Hand").is_enabled()

    first.stroke((40, 60), (100, 60))
    second.until("window.stylitStudio.sender.serial", first.sent())
    assert np.array_equal(second.pixels(), first.pixels())

    second.page.get_by_role("button", name="Take over").click()
    first.until(f"{LINE}.startsWith('Another page has the brush')")
    second.until(LINE, "")
    assert second.page.locator("#size").is_enabled()
    second.stroke((20, 20), (60, 20))
    second.until("window.stylitStudio.sender.isBehind", False)
    first.until(
        "window.stylitStudio.sender.serial", second.page.evaluate("stylitStudio.sender.serial")
    )
    assert np.array_equal(first.pixels(), second.pixels())


def test_painting_goes_on_without_the_server_and_is_sent_when_it_is_back(open_page, studio):
    page = open_page(studio).started()
    page.stroke((40, 30), (100, 30))
    studio.rests(page.sent())
    studio.stop()
    page.until(f"{LINE}.startsWith('The connection is lost. Go on painting')")
    assert page.page.locator("#finish").is_disabled()
    page.stroke((40, 90), (100, 90))
    painted = page.pixels()
    assert not np.array_equal(painted, studio.painting)
    studio.start()
    page.until(LINE, "")
    page.sent()
    assert page.text("said") == "Connected again; what you painted meanwhile is sent."
    page.until("document.getElementById('which').textContent", "coherent")
    page.page.keyboard.press("z")
    page.page.keyboard.press("Shift+Z")
    assert np.array_equal(page.pixels(), painted)
    studio.rests(page.sent())
    assert np.array_equal(studio.painting, painted)
    # The browser itself tells that nobody answers.
    open_page.complaints[:] = [said for said in open_page.complaints if "ERR_CONN" not in said]


def test_a_server_that_lost_strokes_gets_them_again(open_page, studio):
    page = open_page(studio).started()
    page.stroke((40, 30), (100, 30))
    studio.rests(page.sent())
    painted = page.pixels()
    studio.stop()
    studio.painting, studio.serial = studio.beginning.copy(), 0
    studio.start()
    page.until("window.stylitStudio.session.wasLost", False)
    studio.rests(page.sent())
    assert np.array_equal(page.pixels(), painted)
    open_page.complaints[:] = [said for said in open_page.complaints if "ERR_CONN" not in said]


def test_a_painting_does_not_replace_that_of_another_folder(open_page, studio):
    page = open_page(studio).started()
    page.stroke((40, 30), (100, 30))
    studio.rests(page.sent())
    studio.stop()
    other = 255 - studio.beginning
    studio.name, studio.serial = "crayons", 0
    studio.beginning, studio.painting = other, other.copy()
    studio.rectangles.clear()
    studio.start()
    page.until("document.getElementById('name').textContent", "crayons")
    page.until("window.stylitStudio.session.awaited", None)
    page.sent()
    assert np.array_equal(page.pixels(), other)
    assert studio.rectangles == []
    assert page.page.locator("#undo").is_disabled()
    open_page.complaints[:] = [said for said in open_page.complaints if "ERR_CONN" not in said]


def test_a_painting_from_elsewhere_is_taken_over_and_can_be_undone(open_page, studio):
    page = open_page(studio).started()
    other = 255 - studio.beginning
    studio.serial += 1
    studio.say(studio.painting_message(other, studio.serial))
    page.until("window.stylitStudio.artist.history.canUndo")
    assert np.array_equal(page.pixels(), other)
    page.page.keyboard.press("z")
    assert np.array_equal(page.pixels(), studio.beginning)
    studio.rests(page.sent())
    assert np.array_equal(studio.painting, studio.beginning)


def test_of_a_picture_its_changes_are_enough(open_page, studio):
    page = open_page(studio).started()
    before = SentPicture(Picture("coherent", 255 - studio.painting, studio.serial, 42.0))
    image = before.picture.image.copy()
    image[5:40, 100:150] = 1, 2, 3
    image[-1, -1] = 9
    message = SentPicture(Picture("fast", image, studio.serial, 2.0)).message(before)
    assert len(message) < image.size / 2
    studio.say(message)
    page.until("window.stylitStudio.result.which", "fast")
    np.testing.assert_array_equal(page.pixels("picture"), image)


def test_what_the_server_says_is_shown(open_page, studio):
    page = open_page(studio).started()
    studio.say({"say": "notes", "texts": ["The painting of oils is restored."]})
    page.until("document.getElementById('said').textContent", "The painting of oils is restored.")
    studio.say({"say": "compiling", "text": "Kernels are compiled", "done": 2, "total": 5})
    page.until("document.getElementById('compiled').value", 2)
    assert page.page.locator("#compiling").is_visible()
    studio.say({"say": "compiling", "text": "Ready", "done": 5, "total": 5})
    page.until("document.getElementById('compiling').hidden")
    studio.say({"say": "working", "which": "fast", "state": "started", "text": "35%"})
    page.until("document.getElementById('working').textContent", "fast 35%")
    studio.say({"say": "working", "which": "fast", "state": "failed", "text": "Out of memory."})
    page.until("document.getElementById('working').textContent", "")
    problem = page.page.locator("#problems p")
    assert problem.locator("span").text_content() == "Out of memory."
    problem.get_by_role("button").click()
    assert problem.count() == 0
    page.page.clock.install()
    studio.say({"say": "notes", "texts": ["It is read, and passes."]})
    page.until("document.getElementById('said').textContent", "It is read, and passes.")
    page.page.clock.fast_forward(20_000)
    assert page.text("said") == ""
