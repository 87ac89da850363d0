"""What a hand waits for: a patch that is dropped, and a stroke of the brush (section 8)."""

import time
from dataclasses import dataclass

import numpy as np
import pandas as pd

from eval.on_processor import OnProcessor
from eval.outcome import Outcome
from eval.runs.store import stored
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.texture.dragging import drag, drop
from stylit_ref.texture.painting import paint
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession
from stylit_ref.texture.synthesize import synthesize_texture

SIDE, THREADS, REPEATS = 1024, 2, 15

BRUSH = 64
"""Pixels that a round brush is wide, and that it is pulled."""

_WANTED = {"a patch, R = 64": 10, "a patch, R = 128": 40, "a stroke of 64 px": 50}
"""Milliseconds that each may take."""


@dataclass(frozen=True)
class Interaction(OnProcessor):
    """Patches that are dropped and strokes that are painted, late in the synthesis of a texture."""

    name = "what a hand waits for"
    cost = 50.0
    alone = True

    def run(self, texture, seed, progress=None):
        """Synthesize the texture, then do each action several times.

        Parameters
        ----------
        texture : Texture
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The history has wall ``seconds`` and ``processor_seconds`` by ``action``.
        """
        late = synthesize_texture(
            texture.exemplar, texture.shape, TextureParams.preset("paper"), seed=seed
        )
        rng = np.random.default_rng(seed)
        begun, rows = time.perf_counter(), []
        with using_threads(THREADS):
            for action in _WANTED:
                params = TextureParams(radius=128 if "128" in action else 64, radius_step=0)
                session = TextureSession(
                    [texture.exemplar], texture.shape, params, start=late.coordinates
                )
                act = _stroke if "stroke" in action else _patch
                times = [_timed(act, session, rng) for _ in range(REPEATS + 1)][1:]  # compiled then
                rows += [
                    {"action": action, "seconds": wall, "processor_seconds": processor}
                    for wall, processor in times
                ]
        seconds = time.perf_counter() - begun
        return Outcome(session.image, seconds, history=pd.DataFrame(rows))


def interaction(job):
    """Milliseconds of what a hand does to a texture late in its synthesis.

    Parameters
    ----------
    job : Job
        A run of :class:`Interaction`.

    Returns
    -------
    pandas.DataFrame
        Wall time, the least and the median of several, and the least processor time.
    """
    times = 1000 * stored(job).history.set_index("action")
    least, median = times.groupby("action").min(), times.groupby("action").median()
    return pd.DataFrame(
        [
            {
                "action": action, "size of S": job.scene.shape[0], "at most [ms]": wanted,
                "least [ms]": least["seconds"][action], "median [ms]": median["seconds"][action],
                "least of processors [ms]": least["processor_seconds"][action],
            }
            for action, wanted in _WANTED.items()
        ]
    )  # fmt: skip


def _timed(act, session, rng):
    place = tuple(int(at) for at in rng.integers(0, session.size))
    begun = time.perf_counter(), time.process_time()
    act(session, place)
    return time.perf_counter() - begun[0], time.process_time() - begun[1]


def _patch(session, place):
    drop(session, drag(session, (1, 128, 128), place))


def _stroke(session, place):
    y, x = (
        (np.arange(side) - at + side // 2) % side - side // 2
        for side, at in zip(session.size, place, strict=True)
    )
    pulled = np.maximum(0, np.abs(x) - BRUSH // 2)
    paint(session, np.hypot(y[:, None], pulled) < BRUSH / 2, 1)
