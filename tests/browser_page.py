"""A page of the viewer in a browser, as tests ask it."""

import base64

import numpy as np

_READY = "window.stylitViewer || document.getElementById('message')?.textContent.endsWith('.')"

_DRAW = """async ([place, mode, motion, names]) => {
  const { viewer, store } = window.stylitViewer;
  viewer.place = place;
  viewer.motion = motion;
  await store.arrived(viewer.needed);
  const engine = viewer.drawNow(mode);
  return names.map((name) => {
    const values = engine.read(name);
    const bytes = new Uint8Array(values.buffer);
    let letters = "";
    for (let i = 0; i < bytes.length; i += 32768)
      letters += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return [values.constructor.name, btoa(letters)];
  });
}"""


class BrowserPage:
    """A page that is open.

    Attributes
    ----------
    page : playwright.sync_api.Page
    """

    def __init__(self, page):
        self.page = page

    def started(self):
        """Wait until it draws; returns itself."""
        self.page.wait_for_function("window.stylitViewer", timeout=30_000)
        return self

    def rested(self):
        """Wait until it has told where one is, which it does when it rests."""
        self.started()
        self.page.wait_for_function("document.getElementById('view').textContent", timeout=30_000)
        return self

    def says(self):
        """The sentence that stands in place of the drawing."""
        message = self.page.locator("#message")
        self.page.wait_for_function(
            "!document.getElementById('message').hidden && "
            "!document.getElementById('message').textContent.includes('is being loaded')",
            timeout=30_000,
        )
        return message.text_content()

    def draws(self, place, mode, *names, motion="full"):
        """Draw a place, and read buffers, each by rows and columns of a view."""
        read = self.page.evaluate(_DRAW, [list(place), mode, motion, list(names)])
        height, width = self.page.evaluate(
            "[document.getElementById('drawing').height, document.getElementById('drawing').width]"
        )
        arrays = [
            np.frombuffer(base64.b64decode(text), kind.removesuffix("Array").lower())
            for kind, text in read
        ]
        return [array.reshape(height, width, -1) for array in arrays]

    def place(self):
        """Where one is: to the right and upwards."""
        return self.page.evaluate("window.stylitViewer.viewer.place")
