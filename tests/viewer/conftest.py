"""Pages of the viewer in a browser."""

from contextlib import contextmanager

import pytest
from browser_page import BrowserPage
from chromium_browser import chromium_browser
from small_views import small_views

from stylit_ref.viewer.contents import make_contents
from stylit_ref.viewer.write_page import folder_texts, page_bytes, write_folder


@pytest.fixture(scope="module")
def chromium():
    """A browser for the tests of a module."""
    with chromium_browser() as browser:
        yield browser


@contextmanager
def opening(chromium):
    """Opens pages from the disk; a page that complains, or asks a network, fails the test."""
    contexts, complaints = [], []

    def opened(file, query="", **settings):
        context = chromium.new_context(viewport={"width": 640, "height": 560}, **settings)
        contexts.append(context)
        page = context.new_page()
        page.on("console", lambda said: said.type == "error" and complaints.append(said.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on("request", lambda asked: _is_far(asked.url) and complaints.append(asked.url))
        page.goto(file.as_uri() + query)
        return BrowserPage(page)

    yield opened
    for context in contexts:
        context.close()
    assert complaints == []


@pytest.fixture
def open_page(chromium):
    """Opens pages of a test."""
    with opening(chromium) as opened:
        yield opened


@pytest.fixture(scope="module")
def open_shared_page(chromium):
    """Opens pages that the tests of a module share."""
    with opening(chromium) as opened:
        yield opened


def _is_far(url):
    return not url.startswith(("file:", "data:", "blob:"))


@pytest.fixture(scope="session")
def page_file(tmp_path_factory):
    """The small views as one file."""
    contents = make_contents(small_views(), title="Two boxes", band=0.6)
    file = tmp_path_factory.mktemp("page") / "viewer.html"
    file.write_bytes(page_bytes(contents))
    return file


@pytest.fixture
def page_folder(tmp_path):
    """The small views as a folder, which a test may damage."""
    contents = make_contents(small_views(), title="Two boxes", band=0.6)
    write_folder(tmp_path / "page", folder_texts(contents))
    return tmp_path / "page"
