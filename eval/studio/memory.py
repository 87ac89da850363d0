"""Memory of server and page while somebody paints at random."""

import time

import numpy as np
import pandas as pd

from eval.studio.hand import Hand
from eval.studio.start import PICTURE

EARLY, LATE = 10, 60
"""Minutes that are compared."""

PARTS = {
    "server": "the server",
    "background": "its process in the background",
    "page": "the page",
}
"""What must not grow, in words."""

_LEAST_ROWS = 3

_RESTS = 1.5
"""Seconds until a scene that is chosen is there."""

_FIELD = """([kind, chance, place, value]) => {
  const isMoved = (each) => !each.labels[0].textContent.startsWith("patch width");
  const fields = [
    ...document.querySelectorAll(`#${kind}-fields :is([type=range], [type=number])`),
  ].filter(isMoved);
  const field = fields[place ?? Math.floor(chance * fields.length)];
  const before = field.value;
  const [least, most] = [Number(field.min), Number(field.max)];
  field.value = value ?? Math.round(least + chance * (most - least));
  for (const event of ["input", "change"]) field.dispatchEvent(new Event(event));
  return [fields.indexOf(field), before];
}"""
"""Move a slider; gives its place and what it was."""


class Painter:
    """Somebody who does anything that the page allows.

    Parameters
    ----------
    page : eval.studio.browser.Page
    rng : numpy.random.Generator
    """

    def __init__(self, page, rng):
        self._page, self._rng, self._hand = page, rng, Hand(page, rng)

    def act(self):
        """Do something that takes a second or two."""
        deeds = {
            self._paint: 60, self._erase: 8, self._pick: 4, self._pan: 3, self._undo: 12,
            self._redo: 6, self._turn: 10, self._look: 4, self._change_parameter: 6,
            self._change_scene: 3, self._finish: 1, self._wait: 4,
        }  # fmt: skip
        chances = np.array(list(deeds.values())) / sum(deeds.values())
        self._rng.choice(np.array(list(deeds)), p=chances)()

    def _paint(self):
        self._hand.take("brush")
        self._hand.choose_brush()
        self._stroke()

    def _erase(self):
        self._hand.take("eraser")
        self._hand.set("erases-to", self._rng.choice(["beginning", "paper"]))
        self._stroke()

    def _pick(self):
        self._hand.take("picker")
        self._stroke()

    def _pan(self):
        self._hand.take("hand")
        self._stroke()
        self._page.page.locator("#fit").click()

    def _stroke(self):
        self._hand.lower(int(self._rng.integers(5, 40)))
        self._hand.lift()
        self._rest(0.6)

    def _undo(self):
        for _ in range(self._rng.integers(1, 6)):
            self._hand.press("Control+z")
        self._rest(0.4)

    def _redo(self):
        for _ in range(self._rng.integers(1, 6)):
            self._hand.press("Control+Shift+z")
        self._rest(0.4)

    def _turn(self):
        steps = self._page.ask("Number(document.getElementById('turn').max)")
        for _ in range(self._rng.integers(1, 5)):
            self._hand.set("turn", self._rng.integers(0, steps + 1))
            self._rest(0.3)

    def _look(self):
        name = self._rng.choice(["painting-look-choice", "picture-look-choice"])
        self._hand.set(name, self._rng.choice(self._hand.choices(name)))
        self._rest(0.6)

    def _change_parameter(self):
        """Move a slider, paint, and move it back."""
        kind = str(self._rng.choice(["live", "dense"]))
        place, before = self._page.ask(_FIELD, [kind, self._rng.random(), None, None])
        self._paint()
        self._page.ask(_FIELD, [kind, 0, place, before])

    def _change_scene(self):
        self._hand.set("scene", self._rng.choice(self._hand.choices("scene")))
        self._rest(2.0)

    def come_back(self):
        """Choose the first scene, and wait until all is at rest."""
        self._hand.set("scene", self._hand.choices("scene")[0])
        time.sleep(_RESTS)
        self._page.until("document.getElementById('working').textContent === ''")

    def _finish(self):
        self._page.page.locator("#finish").click()
        self._rest(4.0)

    def _wait(self):
        self._rest(8.0)

    def _rest(self, seconds):
        time.sleep(self._rng.exponential(seconds))


def memory(browser, server, page, minutes, rng, tell=print):
    """Paint at random, and look at the memory.

    Parameters
    ----------
    browser : eval.studio.browser.Browser
    server : eval.studio.server.Server
    page : eval.studio.browser.Page
    minutes : float
        How long somebody paints; it takes a little longer.
    rng : numpy.random.Generator
    tell : callable
        Called with a line of text for each row.

    Returns
    -------
    pandas.DataFrame
        A row for each minute, or for each third of a shorter time: ``minute``, ``deeds`` since the
        last, and MiB of ``server``, ``background``, ``page`` and ``heap`` at its end, when all
        rests at the first scene.
    """
    page.until(PICTURE)
    painter, rows, start = Painter(page, rng), [], time.monotonic()
    part = min(60, 60 * minutes / _LEAST_ROWS)
    for _ in range(round(60 * minutes / part)):
        deeds, end = 0, time.monotonic() + part
        while time.monotonic() < end:
            painter.act()
            deeds += 1
        painter.come_back()
        heap = page.heap_mebibytes()
        minute = (time.monotonic() - start) / 60
        rows.append((minute, deeds, *server.mebibytes(), browser.mebibytes(), heap))
        tell(
            "minute {:.1f}: {} deeds; server {:.0f} MiB, background {:.0f} MiB, page {:.0f} MiB, "
            "of which its program {:.1f} MiB".format(*rows[-1])
        )
    return pd.DataFrame(rows, columns=["minute", "deeds", *PARTS, "heap"])


def growth(frame, part, early=EARLY, late=LATE):
    """How much a part has grown between two minutes, over what it was.

    Parameters
    ----------
    frame : pandas.DataFrame
        As :func:`memory` gives it.
    part : str
    early, late : float
        Minutes; the rows next to them count.

    Returns
    -------
    float
    """
    first, last = (
        frame[part].iloc[(frame["minute"] - minute).abs().argmin()] for minute in (early, late)
    )
    return last / first - 1
