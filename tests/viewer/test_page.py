"""The page from the disk: one file and a folder, hands and keys, and what may go wrong."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from small_views import SIZE, small_views

from stylit_ref import read_uint8, replay
from stylit_ref.viewer.contents import make_contents
from stylit_ref.viewer.write_page import folder_texts, page_bytes, write_folder

pytestmark = pytest.mark.slow  # a browser is a process of its own

AXE = Path(__file__).parents[2] / "node_modules/axe-core/axe.min.js"
NO_WEBGL = """HTMLCanvasElement.prototype.getContext = ((get) => function (kind, ...rest) {
  return kind === "webgl2" ? null : get.call(this, kind, ...rest);
})(HTMLCanvasElement.prototype.getContext);"""
NOISE = """CanvasRenderingContext2D.prototype.getImageData = ((get) => function (...where) {
  const image = get.apply(this, where);
  image.data[0] ^= 1;
  return image;
})(CanvasRenderingContext2D.prototype.getImageData);"""
NO_CANVAS = "HTMLCanvasElement.prototype.getContext = () => null;"


def engine_of(page):
    return page.page.evaluate("window.stylitViewer.viewer.engine.name")


def test_a_file_and_a_folder_show_the_same(open_page, page_file, page_folder):
    pictures = [
        open_page(file, "?engine=webgl").started().draws((0.5, 1.0), "limited", "frame0")[0]
        for file in (page_file, page_folder / "index.html")
    ]
    assert np.array_equal(*pictures)
    assert pictures[0].std() > 10


def test_the_canvas_shows_what_was_drawn(open_page, page_file):
    page = open_page(page_file, "?engine=webgl&mode=nnf").rested()
    (drawn,) = page.draws((0.5, 1.0), "nnf", "voted")
    shown = page.page.evaluate("""async () => {
      const canvas = document.getElementById("drawing");
      window.stylitViewer.viewer.drawNow("nnf");
      const bitmap = await createImageBitmap(canvas);
      const flat = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
      flat.drawImage(bitmap, 0, 0);
      return [...flat.getImageData(0, 0, canvas.width, canvas.height).data];
    }""")
    assert np.array_equal(np.uint8(shown).reshape(*SIZE, 4)[..., :3], drawn[..., :3])


def test_arrow_keys_turn_and_home_goes_back(open_page, page_file):
    page = open_page(page_file, "?view=1,1").rested()
    canvas = page.page.locator("#drawing")
    canvas.press("ArrowRight")
    canvas.press("ArrowDown")
    assert page.place() == pytest.approx([1.25, 0.75])
    canvas.press("Shift+ArrowLeft")
    assert page.place() == pytest.approx([-2.5, 0.75])  # held at the grid's edge
    canvas.press("Home")
    assert page.place() == [0, 0]


def test_a_mouse_turns(open_page, page_file):
    page = open_page(page_file).rested()
    box = page.page.locator("#drawing").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.page.mouse.move(x, y)
    page.page.mouse.down()
    page.page.mouse.move(x - box["width"] / 5, y)
    right, up = page.place()
    page.page.mouse.up()
    assert right == pytest.approx(1)  # a fifth of the grid's five degrees
    assert up == pytest.approx(0)


def test_a_finger_turns_and_does_not_scroll(open_page, page_file):
    page = open_page(page_file, has_touch=True, is_mobile=True).rested()
    box = page.page.locator("#drawing").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    touch = page.page.context.new_cdp_session(page.page)
    for kind, points in (
        ("touchStart", [{"x": x, "y": y}]),
        ("touchMove", [{"x": x, "y": y + box["height"] / 5}]),
        ("touchEnd", []),
    ):
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    page.page.wait_for_function("window.stylitViewer.viewer.place[1] > 0.5")
    assert page.page.evaluate("scrollY") == 0


def test_the_drawing_rests_at_once_where_motion_is_unwelcome(open_page, page_file):
    page = open_page(page_file, reduced_motion="reduce").rested()
    box = page.page.locator("#drawing").bounding_box()
    page.page.mouse.move(box["x"] + 50, box["y"] + 50)
    page.page.mouse.down()
    page.page.mouse.move(box["x"] + 90, box["y"] + 50, steps=3)
    page.page.mouse.up()
    left = page.place()
    page.page.wait_for_timeout(150)
    assert page.place() == left != [0, 0]


def test_modes_and_motion_are_chosen_and_asked_for(open_page, page_file):
    page = open_page(page_file, "?mode=blend&motion=half&view=-1.5,2").rested()
    assert page.page.locator("#mode").input_value() == "blend"
    assert page.page.locator("#motion").input_value() == "half"
    assert page.place() == [-1.5, 2]
    page.page.locator("#mode").select_option("linear")
    assert page.page.evaluate("window.stylitViewer.viewer.mode") == "linear"
    assert (
        "1.50 degrees to the left and 2.00 degrees up" in page.page.locator("#view").text_content()
    )


@pytest.mark.parametrize(
    ("query", "said"),
    [
        (
            "?mode=blurred",
            "The address asks for mode=blurred; choose one of linear, image, blend, ",
        ),
        ("?view=2.5", "The address asks for view=2.5; a place is two numbers, such as 2.5,-1.25."),
        (
            "?motion=double&engine=gpu",
            "motion=double; choose one of full, half, quarter. The addre",
        ),
    ],
)
def test_what_the_address_asks_for_in_vain_is_told(open_page, page_file, query, said):
    page = open_page(page_file, query).rested()
    assert said in page.page.locator("#waiting").text_content()
    assert page.place() == [0, 0]


def test_a_mode_that_a_page_lacks_data_for_is_told(open_page, tmp_path):
    views = small_views()
    views = replace(views, style=None, view=lambda frame: np.zeros((*SIZE, 3), np.uint8))
    file = tmp_path / "pictures.html"
    file.write_bytes(page_bytes(make_contents(views, title="Pictures", band=0.6)))
    page = open_page(file, "?mode=fade").rested()
    said = "The address asks for mode=fade, and this page has no data for it."
    assert page.page.locator("#waiting").text_content() == said


def test_limited_search_waits_until_the_drawing_rests(open_page, page_file):
    page = open_page(page_file, "?engine=script&mode=limited&view=1,1").rested()
    page.page.evaluate("window.stylitViewer.viewer.pace.rested(51)")
    page.page.locator("#drawing").press("ArrowRight")
    waiting = "document.getElementById('waiting').textContent"
    page.page.wait_for_function(f"{waiting} === 'Limited search waits until the drawing rests.'")
    page.page.wait_for_function(f"{waiting} === ''")
    assert page.page.locator("#rate").text_content().endswith("frames a second")


PACES = """(frames) => {
  const pace = new window.stylitViewer.viewer.pace.constructor();
  for (const [asked, begun, drawn] of frames) pace.moved(asked, begun, drawn, true);
  return [pace.framesPerSecond, pace.isSlow];
}"""


@pytest.mark.parametrize(
    ("frames", "expected"),
    [
        ([(150 * k, 150 * k, 150 * k + 5) for k in range(9)], [None, True]),  # a key is tapped
        ([(100 * k - 1, 100 * k, 100 * k + 98) for k in range(9)], [10, True]),
        ([(20 * k - 4, 20 * k, 20 * k + 5) for k in range(9)], [50, False]),
    ],
)
def test_the_rate_is_that_of_the_machine_and_not_of_the_hand(
    open_page, page_file, frames, expected
):
    assert open_page(page_file).started().page.evaluate(PACES, frames) == expected


def test_a_still_that_cannot_be_saved_leaves_the_drawing(open_page, page_file):
    page = open_page(page_file).rested().page
    page.evaluate("window.stylitViewer.viewer.use(null)")
    page.click("#save")
    page.wait_for_function("document.getElementById('waiting').textContent.startsWith('Views are')")
    assert page.is_visible("#drawing")


def test_a_lost_context_comes_back_with_the_same_picture(open_page, page_file):
    page = open_page(page_file, "?engine=webgl").rested()
    before = page.draws((0.5, 1.0), "fade", "mixed", "searched")
    page.page.evaluate("""() => {
      const { viewer } = window.stylitViewer;
      window.lost = viewer.engine.context.gl.getExtension("WEBGL_lose_context");
      window.lost.loseContext();
    }""")
    page.page.wait_for_function("window.stylitViewer.viewer.engine === null")
    page.page.evaluate("window.lost.restoreContext()")
    page.page.wait_for_function("window.stylitViewer.viewer.engine !== null")
    after = page.draws((0.5, 1.0), "fade", "mixed", "searched")
    for each, again in zip(before, after, strict=True):
        assert np.array_equal(each, again)


def test_javascript_draws_where_there_is_no_webgl(open_page, page_file):
    page = open_page(page_file)
    page.page.add_init_script(NO_WEBGL)
    page.page.reload()
    assert engine_of(page.rested()) == "script"
    (picture,) = page.draws((0.5, 1.0), "limited", "frame0")
    assert picture.std() > 10


def test_noise_that_hides_a_user_does_not_damage_a_page(open_page, page_file):
    page = open_page(page_file)
    page.page.add_init_script(NOISE)
    page.page.reload()
    clean = open_page(page_file)
    shown = [each.started().draws((0.5, 1.0), "limited", "frame0")[0] for each in (page, clean)]
    assert np.array_equal(*shown)


def test_a_sentence_where_nothing_can_draw(open_page, page_file):
    page = open_page(page_file)
    page.page.add_init_script(NO_CANVAS)
    page.page.reload()
    assert "neither with WebGL 2 nor on a canvas" in page.says()
    assert not page.page.locator("#viewer").is_visible()


@pytest.mark.parametrize(
    ("damage", "said"),
    [
        (lambda text: re.sub('(id="view-0-0">)(?s:.{9})', r"\1AAAAAAAAA", text), "view-0-0 does"),
        (lambda text: text[: text.index('id="view-1-0">') + 900], "This page is "),
        (lambda text: text[: text.index('id="stylit-data">') + 200], "table of contents"),
        (lambda text: text[: text.index('<script type="app')], "holds no drawing"),
        (lambda text: text.replace('"format": 1', '"format": 2', 1), "of format 2"),
        (lambda text: text.encode("utf-8").decode("latin-1"), "in another text encoding"),
    ],
    ids=["bytes", "end", "contents", "data", "format", "encoding"],
)
def test_a_damaged_file_says_so(open_page, page_file, tmp_path, damage, said):
    file = tmp_path / "damaged.html"
    file.write_bytes(damage(page_file.read_bytes().decode("latin-1")).encode("latin-1"))
    assert said in open_page(file).says()


def test_an_editor_that_changes_encoding_and_line_ends_does_no_harm(open_page, page_file, tmp_path):
    """As long as it tells the encoding: characters stay what they are."""
    file = tmp_path / "edited.html"
    text = "".join(map(windows_1252, page_file.read_bytes())).replace("\n", "\r\n")
    file.write_bytes(text.replace("windows-1252", "utf-8", 1).encode())
    shown = [
        open_page(each).started().draws((0.5, 1.0), "nnf", "voted")[0] for each in (file, page_file)
    ]
    assert np.array_equal(*shown)


def windows_1252(byte):
    """The character of a byte as browsers have it; Python lacks five of them."""
    try:
        return bytes([byte]).decode("cp1252")
    except UnicodeDecodeError:
        return chr(byte)


def test_a_server_that_tells_another_encoding_does_no_harm(chromium, page_file):
    page = chromium.new_page()
    page.route("http://page.test/", lambda route: route.fulfill(
        body=page_file.read_bytes(), content_type="text/html; charset=utf-8"
    ))  # fmt: skip
    page.goto("http://page.test/")
    page.wait_for_function("window.stylitViewer", timeout=30_000)
    assert page.evaluate("document.characterSet") == "UTF-8"
    page.close()


def test_a_file_that_ends_within_its_program_shows_a_sentence(chromium, page_file, tmp_path):
    page = page_file.read_bytes()
    file = tmp_path / "damaged.html"
    file.write_bytes(page[: page.index(b"<script>") + 2000])
    page = chromium.new_page()
    page.goto(file.as_uri())
    assert "the file is incomplete" in page.locator("#message").text_content()
    assert not page.locator("#viewer").is_visible()
    page.close()


def test_a_damaged_file_of_a_folder_is_named(page_folder, chromium):
    file = page_folder / "data" / "style.js"
    file.write_text(file.read_text().replace('", "', '", "?'))
    page = chromium.new_page()
    page.goto((page_folder / "index.html").as_uri())
    page.wait_for_function("document.getElementById('message').textContent.includes('damaged')")
    message = page.locator("#message").text_content()
    assert message == "data/style.js is damaged. Copy the whole folder again."
    page.close()


def test_a_missing_file_of_a_folder_is_named(open_page, page_folder, chromium):
    (page_folder / "data" / "view-0-1.js").unlink()
    page = chromium.new_page()
    page.goto((page_folder / "index.html").as_uri())
    message = page.locator("#message")
    page.wait_for_function("document.getElementById('message').textContent.includes('missing')")
    assert message.text_content() == "data/view-0-1.js is missing. Copy the whole folder again."
    page.close()


@pytest.mark.parametrize("engine", ["webgl", "script"])
def test_a_still_is_the_replay_in_the_larger_style(open_page, tmp_path, engine):
    views = small_views()
    large = np.random.default_rng(1).integers(0, 256, (100, 80, 3), dtype=np.uint8)
    contents = make_contents(views, title="Still", band=0.6, still=large)
    file = tmp_path / "still.html"
    file.write_bytes(page_bytes(contents))
    page = open_page(file, f"?engine={engine}&mode=limited&view=0.5,1").rested()
    with page.page.expect_download() as download:
        page.page.locator("#save").click()
    still = read_uint8(download.value.path())
    (searched,) = page.draws((0.5, 1.0), "limited", "searched")
    expected = replay(searched.astype(np.int32), large, patch_width=5, scale=2)
    assert np.array_equal(still[..., :3], expected)


@pytest.mark.parametrize("engine", ["webgl", "script"])
def test_a_still_of_a_fade_fades(open_page, tmp_path, engine):
    views = small_views()
    file = tmp_path / "still.html"
    contents = make_contents(views, title="Still", band=0.6, still=views.style)
    file.write_bytes(page_bytes(contents))
    page = open_page(file, f"?engine={engine}&mode=fade&view=0.2,-0.3").rested()
    with page.page.expect_download() as download:
        page.page.locator("#save").click()
    still = read_uint8(download.value.path())[..., :3]
    # In the style's own size it is the picture that the page shows.
    (faded,) = page.draws((0.2, -0.3), "fade", "mixed")
    (closest,) = page.draws((0.2, -0.3), "limited", "frame0")
    assert np.array_equal(still, faded[..., :3])
    assert not np.array_equal(still, closest[..., :3])


def test_a_grid_takes_as_many_textures_as_it_has_views(open_page, page_file):
    page = open_page(page_file, "?engine=webgl").rested().page
    assert page.evaluate("window.stylitViewer.viewer.engine.stage.slots") == 4


def test_a_large_grid_is_streamed(open_page, tmp_path):
    views = small_views(5, 5, size=(20, 24), style_size=(30, 30))
    contents = make_contents(views, title="Many", band=0.6)
    write_folder(tmp_path, folder_texts(contents))
    page = open_page(tmp_path / "index.html", "?engine=webgl&view=-9,-9&mode=limited").rested()
    page.page.wait_for_function("window.stylitViewer.store.slots.size === 9")  # the cells beside
    first = page.draws((-9, -9), "limited", "frame0")[0]
    for place in ((-4, -9), (1, -9), (6, -9), (-9, -1), (1, -1), (6, -1), (6, 6), (-9, 6)):
        page.draws(place, "limited", "frame0")
    kept = page.page.evaluate("[...window.stylitViewer.store.slots.values()]")
    assert sorted(kept) == list(range(16))
    assert np.array_equal(page.draws((-9, -9), "limited", "frame0")[0], first)


def test_axe_finds_nothing(open_page, page_file):
    if not AXE.exists():
        pytest.skip("axe-core is not installed; run make bundles")
    page = open_page(page_file).rested()
    page.page.add_script_tag(path=AXE)
    found = page.page.evaluate(
        "async () => (await axe.run()).violations.map((v) => [v.id, v.help])"
    )
    assert found == []


def test_the_drawing_has_a_text_and_a_ring_when_it_has_the_focus(open_page, page_file):
    page = open_page(page_file).rested()
    canvas = page.page.locator("#drawing")
    assert canvas.get_attribute("aria-label").startswith("Two boxes, seen 0.00 degrees")
    page.page.keyboard.press("Tab")
    assert canvas.evaluate("(it) => it === document.activeElement")
    assert canvas.evaluate("(it) => getComputedStyle(it).outlineStyle") == "solid"
