"""A page of the studio in a browser, as tests drive it."""

import base64
import time

import numpy as np

_PIXELS = """name => {
  const canvas = document.getElementById(name);
  const shown = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  let letters = "";
  for (let i = 0; i < shown.length; i += 32768)
    letters += String.fromCharCode(...shown.subarray(i, i + 32768));
  return [canvas.height, canvas.width, btoa(letters)];
}"""


class StudioPage:
    """A page that is open.

    Attributes
    ----------
    page : playwright.sync_api.Page
    """

    def __init__(self, page):
        self.page = page

    def until(self, script, wanted=True, seconds=10):
        """Wait until a script gives what is wanted. The page's policy forbids Playwright's way."""
        end = time.monotonic() + seconds
        while (found := self.page.evaluate(script)) != wanted:
            assert time.monotonic() < end, f"{script} gives {found!r}"
            time.sleep(0.01)

    def started(self, seconds=10):
        """Wait until it has the painting and the picture; returns itself."""
        self.until("!!window.stylitStudio?.session.painting")
        self.until("document.getElementById('empty').hidden", seconds=seconds)
        return self

    def unfold(self):
        """Open all panels."""
        self.page.evaluate("document.querySelectorAll('details').forEach((it) => (it.open = true))")

    def at(self, x, y):
        """The place in the window of a pixel of the painting."""
        box = self.page.locator("#painting").bounding_box()
        width = self.page.evaluate("document.getElementById('painting').width")
        scale = box["width"] / width
        return box["x"] + (x + 0.5) * scale, box["y"] + (y + 0.5) * scale

    def stroke(self, *places, steps=4):
        """Paint with the mouse from pixel to pixel of the painting."""
        mouse = self.page.mouse
        mouse.move(*self.at(*places[0]))
        mouse.down()
        for place in places[1:]:
            mouse.move(*self.at(*place), steps=steps)
        mouse.up()

    def sent(self):
        """Wait until the server has been sent all; gives the serial of the last message."""
        self.until("""(({ isBehind, isResting, rested, serial }) =>
          !window.stylitStudio.artist.isPainting && !isBehind && (!isResting || rested === serial)
        )(window.stylitStudio.sender)""")
        return self.page.evaluate("window.stylitStudio.sender.serial")

    def pixels(self, canvas="painting"):
        """The painting, or the picture, as its canvas shows it, (H, W, 3) uint8."""
        self.page.evaluate("new Promise(requestAnimationFrame)")
        height, width, letters = self.page.evaluate(_PIXELS, canvas)
        rgba = np.frombuffer(base64.b64decode(letters), np.uint8).reshape(height, width, 4)
        assert (rgba[..., 3] == 255).all()
        return rgba[..., :3]

    def set(self, name, value):
        """Set a control, as a hand does."""
        control = self.page.locator(f"#{name}")
        control.evaluate(
            "(it, value) => { it.value = value;"
            " for (const kind of ['input', 'change']) it.dispatchEvent(new Event(kind)); }",
            str(value),
        )

    def text(self, name):
        """What an element says."""
        return self.page.locator(f"#{name}").text_content()
