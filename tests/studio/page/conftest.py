"""Pages of the studio in a browser."""

import pytest
from chromium_browser import chromium_browser
from fake_studio import FakeStudio
from studio_page import StudioPage


@pytest.fixture(scope="module")
def chromium():
    """A browser for the tests of a module."""
    with chromium_browser() as browser:
        yield browser


@pytest.fixture
def make_studio():
    """Makes servers that speak the studio's protocol."""
    made = []

    def make(**settings):
        made.append(FakeStudio(**settings))
        return made[-1]

    yield make
    for server in made:
        server.stop()


@pytest.fixture
def studio(make_studio):
    """A server that speaks the studio's protocol."""
    return make_studio()


@pytest.fixture
def open_page(chromium, make_studio):
    """Opens pages; one that complains, or asks another server, fails the test.

    Pages are closed before the servers, which they would miss.
    """
    contexts, complaints, servers = [], [], []

    def tell_far(url):
        known = (server.address for server in servers)
        ways_in = (server.login for server in servers if hasattr(server, "login"))
        if not url.startswith(("data:", *known, *ways_in)):
            complaints.append(url)

    def opened(server, size=(1000, 640), context=None, **settings):
        servers.append(server)
        if context is None:
            viewport = dict(zip(("width", "height"), size, strict=True))
            context = chromium.new_context(viewport=viewport, **settings)
            context.set_default_timeout(5000)
            contexts.append(context)
        page = context.new_page()
        page.on("console", lambda said: said.type == "error" and complaints.append(said.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on("request", lambda asked: tell_far(asked.url))
        page.goto(getattr(server, "login", server.address))
        page.wait_for_url(server.address)
        return StudioPage(page)

    opened.complaints = complaints
    yield opened
    for context in contexts:
        context.close()
    assert complaints == []
