"""What a patch late in the synthesis costs by stage, and the memory of a session (section 8)."""

import time
import tracemalloc
from dataclasses import dataclass

import pandas as pd

from eval.documents.lasram.one_patch import OnePatch
from eval.on_processor import OnProcessor
from eval.outcome import Outcome
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession
from stylit_ref.texture.synthesize import synthesize_texture

REPEATS = 40
"""The least time of so many is that of a stage: nothing else ran in between."""

SHARED = "C: DP initialization", "C: DP", "D: DP initialization", "D: DP"
"""The paper's four stages."""


@dataclass(frozen=True)
class PatchCosts(OnProcessor):
    """The stages of one patch, with the paper's settings."""

    name = "a patch by stage"
    cost = 20.0
    alone = True

    def run(self, texture, seed, progress=None):
        """Synthesize the texture, then do each stage of a patch many times.

        Parameters
        ----------
        texture : Texture
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The history has one row: the share of each of :data:`SHARED`, and the most
            ``megabytes`` of arrays while a session is made and steps once.
        """
        params, begun = TextureParams.preset("paper"), time.perf_counter()
        late = synthesize_texture(texture.exemplar, texture.shape, params, seed=seed)
        session = TextureSession([texture.exemplar], texture.shape, params, start=late.coordinates)
        row = stage_shares(session) | {"megabytes": _megabytes(texture, params)}
        seconds = time.perf_counter() - begun
        return Outcome(session.image, seconds, history=pd.DataFrame([row]))


def stage_shares(session):
    """The share that each of the paper's four stages has in the time of a patch.

    Parameters
    ----------
    session : TextureSession

    Returns
    -------
    dict of str to float
    """
    height, width = session.size
    centres = session.exemplars.centres(session.params.radius)
    patch = OnePatch(session, (height // 2, width // 2), int(centres[centres.size // 2]))
    acts = patch.read, patch.begin_cut, patch.cut, patch.begin_alignment, patch.align, patch.write
    seconds = [_least_seconds(act) for act in acts]
    return {name: each / sum(seconds) for name, each in zip(SHARED, seconds[1:5], strict=True)}


def _least_seconds(act):
    act()  # compiled first
    times = []
    for _ in range(REPEATS):
        begun = time.perf_counter()
        act()
        times.append(time.perf_counter() - begun)
    return min(times)


def _megabytes(texture, params):
    tracemalloc.start()
    try:
        TextureSession([texture.exemplar], texture.shape, params).step()
        return tracemalloc.get_traced_memory()[1] / 1e6
    finally:
        tracemalloc.stop()
