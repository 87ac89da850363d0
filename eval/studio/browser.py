"""A browser, led by Playwright, and the memory of its pages."""

import shutil
import time
from contextlib import contextmanager

from eval.studio.resident import mebibytes
from stylit_ref import InputError

WINDOW = {"width": 1280, "height": 800}

_FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
)  # fmt: skip

_LONGEST = 180
"""Seconds that a page may take for anything."""

_TICK = 0.005


class Browser:
    """Chromium.

    Parameters
    ----------
    chromium : playwright.sync_api.Browser
    """

    def __init__(self, chromium):
        self._chromium = chromium
        self._session = chromium.new_browser_cdp_session()
        self.name = f"Chromium {chromium.version}"

    @contextmanager
    def page(self, address):
        """Open a page with cookies of its own; it is closed at the end."""
        context = self._chromium.new_context(viewport=WINDOW)
        try:
            page = context.new_page()
            page.goto(address)
            yield Page(page, context.new_cdp_session(page))
        finally:
            context.close()

    def mebibytes(self):
        """Resident memory of all processes that show pages."""
        processes = self._session.send("SystemInfo.getProcessInfo")["processInfo"]
        return sum(mebibytes(each["id"]) for each in processes if each["type"] == "renderer")


class Page:
    """A page that is open.

    Attributes
    ----------
    page : playwright.sync_api.Page
    """

    def __init__(self, page, session):
        self.page, self._session = page, session

    def ask(self, script, argument=None):
        """What a script gives in the page."""
        return self.page.evaluate(script, argument)

    def until(self, script, argument=None):
        """Wait until a script gives something true.

        Raises
        ------
        InputError
            If it takes minutes.
        """
        end = time.monotonic() + _LONGEST
        while not self.ask(script, argument):
            if time.monotonic() > end:
                raise InputError(f"the page did not come so far in {_LONGEST} s: {script}")
            time.sleep(_TICK)

    def heap_mebibytes(self):
        """What its program holds after garbage has been collected; pixels are not counted."""
        self._session.send("HeapProfiler.collectGarbage")
        self._session.send("Performance.enable")
        metrics = self._session.send("Performance.getMetrics")["metrics"]
        return next(each["value"] for each in metrics if each["name"] == "JSHeapUsedSize") / 2**20


@contextmanager
def open_browser():
    """Chromium as it is installed.

    Yields
    ------
    Browser

    Raises
    ------
    InputError
        If Chromium or Playwright is missing.
    """
    try:
        from playwright.sync_api import sync_playwright
    except ModuleNotFoundError:
        raise InputError(
            "to lead a browser, Playwright is needed: pip install -e '.[test]'"
        ) from None
    found = shutil.which("chromium") or shutil.which("chromium-browser")
    if found is None:
        raise InputError("there is no Chromium; install it (Debian: apt install chromium)")
    with sync_playwright() as driver:
        chromium = driver.chromium.launch(executable_path=found, args=list(_FLAGS))
        try:
            yield Browser(chromium)
        finally:
            chromium.close()
