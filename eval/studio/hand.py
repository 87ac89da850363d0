"""A hand that paints on the page with the mouse."""

import time

import numpy as np

_PACE = 1 / 60
"""Seconds between two places of the mouse."""

_SET = """([name, value]) => {
  const control = document.getElementById(name);
  control.value = value;
  for (const kind of ["input", "change"]) control.dispatchEvent(new Event(kind));
}"""

_PLACES = """() => {
  const { left, top, width, height } = document.getElementById("painting").getBoundingClientRect();
  const pane = document.getElementById("easel").getBoundingClientRect();
  return [
    Math.max(left, pane.left), Math.max(top, pane.top),
    Math.min(left + width, pane.right), Math.min(top + height, pane.bottom),
  ];
}"""


class Hand:
    """A hand on a page.

    Parameters
    ----------
    page : eval.studio.browser.Page
    rng : numpy.random.Generator
        Decides all that is left open.
    """

    def __init__(self, page, rng):
        self._page, self._rng = page, rng

    def set(self, name, value):
        """Set a control of the page by its name."""
        self._page.ask(_SET, [name, str(value)])

    def press(self, keys):
        """Press keys on the painting."""
        self._page.page.locator("#easel").press(keys)

    def take(self, tool):
        """Take brush, eraser, picker or hand."""
        self._page.page.locator(f"button[data-tool={tool}]").click()

    def choose_brush(self):
        """Take any colour and shape of the brush."""
        rng = self._rng
        self.set("hue", rng.integers(0, 361))
        self.set("saturation", rng.integers(0, 101))
        self.set("value", rng.integers(0, 101))
        self.set("size", rng.integers(70, 180))
        self.set("opacity", rng.integers(20, 101))
        self.set("hardness", rng.integers(0, 101))
        self.set("smoothing", rng.integers(0, 60))
        self.set("grain", rng.choice(self.choices("grain")))

    def choices(self, name):
        """Values of a list."""
        return self._page.ask("name => [...document.getElementById(name)].map(o => o.value)", name)

    def lower(self, moves):
        """Begin a stroke somewhere, and lead it to so many places, one in each frame."""
        mouse = self._page.page.mouse
        places = curve(self._rng, self._page.ask(_PLACES), moves + 1)
        mouse.move(*places[0])
        mouse.down()
        due = time.perf_counter()
        for place in places[1:]:
            due += _PACE
            time.sleep(max(0, due - time.perf_counter()))
            mouse.move(*place)

    def lift(self):
        """End the stroke."""
        self._page.page.mouse.up()


def curve(rng, box, count):
    """Places along a stroke that bends, within a box.

    Parameters
    ----------
    rng : numpy.random.Generator
    box : (float, float, float, float)
        Left, top, right, bottom.
    count : int

    Returns
    -------
    list of (float, float)
        x and y.
    """
    low, high = np.reshape(box, (2, 2))
    margin = 0.1 * (high - low)
    low, high = low + margin, high - margin
    angles = rng.uniform(0, 2 * np.pi) + np.cumsum(rng.normal(0, 0.35, count))
    steps = rng.uniform(2, 16) * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return [
        tuple(map(float, place))
        for place in np.clip(rng.uniform(low, high) + np.cumsum(steps, axis=0), low, high)
    ]
