"""Pages of reports in Chromium: contents, pictures that enlarge, and pairs that are compared."""

import io

import numpy as np
import pandas as pd
import pytest
from chromium_browser import chromium_browser
from PIL import Image

from eval.pages.page import new_report
from eval.pages.tables import table

DESK, PHONE = {"width": 1280, "height": 800}, {"width": 390, "height": 800}

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def browser():
    with chromium_browser() as browser:
        yield browser


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """A report of a red picture, a blue one, both compared, and one that moves."""
    folder = tmp_path_factory.mktemp("pages") / "report"
    red, blue = (np.full((200, 300, 3), colour, np.uint8) for colour in ((220, 0, 0), (0, 0, 220)))
    wide = pd.DataFrame({f"a long title {k}": ["1.25"] for k in range(20)})
    with new_report(folder) as report:
        report.page(
            "Red & blue",
            [
                "## Pictures",
                report.figure("red", "only red", save, red),
                report.pair("both", ("red", red), ("blue", blue)),
                report.figure("moves", "from red to blue", save, red, blue),
                "## Numbers",
                table(wide),
                "## More",
                "## Still more",
            ],
        )
    return folder / "report.html"


def save(*images_and_file):
    *images, file = images_and_file
    first, *others = map(Image.fromarray, images)
    first.save(file, save_all=True, append_images=others, duration=100, loop=0)


@pytest.fixture
def opened(browser, file):
    """Opens the report; complaints of its console are kept as ``complaints``."""
    pages = []

    def opened(size, **options):
        page = browser.new_page(viewport=size, **options)
        pages.append(page)
        page.complaints = []
        page.on("console", lambda message: page.complaints.append(message.text))
        page.on("pageerror", lambda error: page.complaints.append(str(error)))
        page.on("request", lambda request: asked(page, request.url))
        page.goto(file.as_uri())
        return page

    def asked(page, url):
        if not url.startswith(("file:", "data:")):
            page.complaints.append(url)

    yield opened
    for page in pages:
        page.close()


@pytest.mark.parametrize("size", [DESK, PHONE], ids=["desk", "phone"])
def test_nothing_is_wider_than_the_window_and_nothing_comes_from_elsewhere(opened, size):
    page = opened(size)
    assert page.evaluate("document.documentElement.scrollWidth") == size["width"]
    assert page.complaints == []


def test_contents_lead_to_their_heading_and_are_folded_on_a_phone(opened):
    assert opened(DESK).get_by_role("link", name="Numbers").is_visible()
    page = opened(PHONE)
    assert not page.get_by_role("link", name="Numbers").is_visible()
    page.get_by_text("Contents").click()
    page.get_by_role("link", name="Numbers").click()
    assert page.url.endswith("#numbers")
    assert page.locator("#numbers").inner_text() == "Numbers"


def test_a_key_enlarges_a_picture_and_arrows_lead_to_the_next(opened):
    page = opened(DESK)
    page.get_by_role("button", name="Enlarge: only red").focus()
    page.keyboard.press("Enter")
    large = page.locator("dialog img")
    assert large.get_attribute("alt") == "only red"
    assert large.bounding_box()["width"] > 300
    page.keyboard.press("ArrowRight")
    assert page.locator("dialog .compare").is_visible()
    page.keyboard.press("ArrowRight")
    assert page.locator("dialog img").get_attribute("alt") == "from red to blue"
    page.keyboard.press("Escape")
    assert not page.locator("dialog").is_visible()
    page.locator("button[aria-label='Enlarge: from red to blue']:focus").wait_for()


@pytest.mark.parametrize("where", ["main", "dialog"])
def test_keys_move_the_slider_of_a_pair(opened, where):
    page = opened(DESK)
    if where == "dialog":
        page.locator(".compare .enlarge").click()
    pair = page.locator(f"{where} .compare")
    pair.locator("input").focus()
    page.keyboard.press("Home")
    assert pixel(pair.locator(".pair"), 0.1)[2] > 200
    page.keyboard.press("End")
    assert pixel(pair.locator(".pair"), 0.9)[0] > 200


def test_a_pointer_moves_the_slider_of_a_pair(opened):
    page = opened(PHONE)
    pair = page.locator(".pair")
    pair.click(position={"x": 0.75 * pair.bounding_box()["width"], "y": 20})
    assert pixel(pair, 0.6)[0] > 200
    assert pixel(pair, 0.9)[2] > 200


def pixel(locator, share):
    """A pixel of what an element looks like, that far to the right."""
    with Image.open(io.BytesIO(locator.screenshot())) as image:
        return image.convert("RGB").getpixel((int(share * image.width), image.height // 2))


def test_a_preview_stands_still_for_who_wants_no_motion(opened):
    source = "document.querySelector('img[data-moves]').src.slice(0, 15)"
    assert opened(DESK).evaluate(source) == "data:image/webp"
    page = opened(DESK, reduced_motion="reduce")
    page.wait_for_function(f"{source} === 'data:image/png;'")
