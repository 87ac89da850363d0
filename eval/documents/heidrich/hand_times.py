"""What a hand waits for: a new view, a stroke in the style, a camera that moves."""

import time
from dataclasses import dataclass, replace

import numpy as np
import pandas as pd

from eval.methods.realtime import Frames
from eval.on_processor import OnProcessor
from eval.outcome import Outcome
from stylit_ref.machine.forks import available_threads
from stylit_ref.realtime.params import RealtimeParams

WAITED = {
    "cold": "another target, from nothing",
    "stroke": "another style, its pyramid included; coarse levels are kept",
    "warm": "a target that has moved by a pixel, from the last frame's NNF",
}
"""What is waited for, in the order of a turn."""


@dataclass(frozen=True)
class HandTimes(OnProcessor):
    """Frames on all threads, from the caller's buffers to a picture, kernels compiled.

    Presets and what is waited for take turns, so that what else the machine does falls on all.

    Attributes
    ----------
    presets : tuple of str
    rounds : int
        The history has the median of so many, and the least.
    """

    presets: tuple[str, ...]
    rounds: int

    name = "hand"
    cost = 5.0
    alone = True

    def run(self, scene, seed, progress=None):
        """Make the frames.

        Parameters
        ----------
        scene : Scene
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The history has a row for each preset and each of :data:`WAITED`: ``preset``,
            ``waited_for``, ``median`` and ``least`` in milliseconds. The image is the last one's.
        """
        makers = {
            preset: Frames(scene, RealtimeParams.preset(preset), (), seed, available_threads())
            for preset in self.presets
        }
        begun = time.perf_counter()
        turns = []
        for number in range(self.rounds + 1):
            near, on = (_moved(scene, view) for view in (2 * number, 2 * number + 1))
            turn = {}
            for preset, frames in makers.items():
                for kind in WAITED:
                    if kind == "warm":  # a camera that moves makes one warm frame after another
                        frames.show(near)
                        _frame(frames, scene.style, kind)
                        frames.show(on)
                    before = time.perf_counter()
                    image = _frame(frames, scene.style, kind)
                    turn[preset, kind] = 1000 * (time.perf_counter() - before)
            turns.append(turn)
        spent = pd.DataFrame(turns[1:])  # the first turn compiles
        rows = [
            {"preset": preset, "waited_for": kind, "median": times.median(), "least": times.min()}
            for (preset, kind), times in spent.items()
        ]
        return Outcome(image, time.perf_counter() - begun, history=pd.DataFrame(rows))


def _moved(scene, view):
    """The scene in a view by a camera that goes up to 16 pixels to the side and back, by one each.

    Its edge is repeated.
    """
    pixels = abs((view + 16) % 32 - 16)
    width = scene.target_guides[0].shape[1]
    columns = (np.arange(width) - pixels).clip(0)
    shifted = {
        name: (source, np.ascontiguousarray(target[:, columns]))
        for name, (source, target) in scene.buffers.items()
    }
    return replace(scene, buffers=shifted)


def _frame(frames, style, kind) -> np.ndarray:
    if kind == "stroke":
        frames.session.set_style(style)
        return frames.session.frame()
    if kind == "cold":
        return frames.frame()
    frames.take()
    return frames.session.frame(warm=True)
