"""Debian's Chromium for tests. Where it or Playwright is missing, they say so and skip."""

import shutil
from contextlib import contextmanager

import pytest

FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
)  # fmt: skip
"""WebGL 2 without a graphics processor; and nothing that would reach for the network."""


@contextmanager
def chromium_browser():
    """A browser, for the tests of a module: its event loop would be in the way of others."""
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="pip install playwright, which the extra test has"
    )
    found = shutil.which("chromium") or shutil.which("chromium-browser")
    if found is None:
        pytest.skip("there is no Chromium; install it (Debian: apt install chromium)")
    with playwright.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=found, args=list(FLAGS))
        yield browser
        browser.close()
