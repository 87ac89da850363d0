"""How long paint takes from the hand to the frame that shows it."""

import time

import pandas as pd

from eval.studio.hand import Hand

_PAUSE = 0.08
"""Seconds after which the page takes a brush that is down for resting."""

_MARGIN = 0.03

_IS_FAST_GOING = "/fast \\d/.test(document.getElementById('working').textContent)"
_IS_ANSWERED = """serial => stylitStudio.latency.times.some(
  (each) => each.which === "coherent" && each.serial >= serial
)"""
_SERIAL = "stylitStudio.sender.serial"
_TAKE = "stylitStudio.latency.times.splice(0)"


def latencies(page, strokes, rng, tell):
    """Paint strokes, each of which begins while the picture ``fast`` is being made.

    Every other stroke pauses before the brush is lifted.

    Parameters
    ----------
    page : eval.studio.browser.Page
    strokes : int
    rng : numpy.random.Generator
    tell : callable
        Called after each stroke.

    Returns
    -------
    pandas.DataFrame
        A row for each change of the painting (``replay``) and each stroke (``coherent``):
        ``stroke``, ``which``, and ``milliseconds`` from the event of the pointer, or from the end
        of the pause, until the frame with the picture is painted.
    """
    hand = Hand(page, rng)
    hand.take("brush")
    page.until(_IS_FAST_GOING)
    page.ask(_TAKE)
    rows = []
    for stroke in range(strokes):
        hand.choose_brush()
        page.until(_IS_FAST_GOING)
        time.sleep(rng.uniform(0, 0.05))
        before = page.ask(_SERIAL)
        hand.lower(int(rng.integers(6, 13)))
        if stroke % 2:
            _await_answer(page, before)
        hand.lift()
        _await_answer(page, before)
        rows += [{"stroke": stroke, **each} for each in page.ask(_TAKE)]
        tell()
    return pd.DataFrame(rows)[["stroke", "which", "milliseconds"]]


def _await_answer(page, before):
    """Wait until the page shows a picture that was searched after the brush had paused.

    A stroke of faint, coarse paint may leave none at all; then there is nothing to wait for.
    """
    time.sleep(_PAUSE + _MARGIN)
    serial = page.ask(_SERIAL)
    if serial != before:
        page.until(_IS_ANSWERED, serial)
