"""What a hand waits for: a patch that is dropped, and a stroke of the brush (section 8)."""

import time

import numpy as np
import pandas as pd

from eval.runs.store import stored
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.texture.dragging import drag, drop
from stylit_ref.texture.painting import paint
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession

SIDE, THREADS, REPEATS = 1024, 2, 15

BRUSH = 64
"""Pixels that a round brush is wide, and that it is pulled."""

_WANTED = {"a patch, R = 64": 10, "a patch, R = 128": 40, "a stroke of 64 px": 50}
"""Milliseconds that each may take."""


def interaction(plan):
    """Milliseconds of what a hand does to a texture late in its synthesis.

    Parameters
    ----------
    plan : Plan

    Returns
    -------
    pandas.DataFrame
        Wall time, the least and the median of several, and the least processor time.
    """
    size = min(SIDE, max(plan.preset.sizes))
    job = plan.timed(size)
    rng = np.random.default_rng(0)
    rows = []
    with using_threads(THREADS):
        for name, wanted in _WANTED.items():
            params = TextureParams(radius=128 if "128" in name else 64, radius_step=0)
            session = TextureSession(
                [job.scene.exemplar], (size, size), params, start=stored(job).coordinates
            )
            act = _stroke if "stroke" in name else _patch
            times = [_timed(act, session, rng) for _ in range(REPEATS + 1)][1:]  # compiled before
            least, processor = 1000 * np.min(times, axis=0)
            rows.append(
                {
                    "action": name, "size of S": size, "at most [ms]": wanted,
                    "least [ms]": least, "median [ms]": 1000 * np.median(times, axis=0)[0],
                    "least of processors [ms]": processor,
                }
            )  # fmt: skip
    return pd.DataFrame(rows)


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
