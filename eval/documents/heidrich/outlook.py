"""What the thesis' outlook asks (chapter 7): how few buffers are enough, and a compromise."""

import time
from dataclasses import dataclass, replace

import pandas as pd

from eval.device import processor
from eval.methods.realtime import Frames, Realtime, outcome_of
from eval.metrics.image_energy import image_energy
from eval.outcome import Outcome
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.realtime.packing.stage import STAGE_BUFFERS
from stylit_ref.realtime.params import RealtimeParams

_CODE = code_digest(__file__, without=("gpu_cuda",))

TOLERATED = 1.02
"""Energy may rise by so much while buffers are left out."""


@dataclass(frozen=True)
class Hybrid:
    """The optimized method, but for the finest level, which compares patches as the simple one."""

    name = "hybrid"
    cost = 0.2

    @property
    def code(self):
        """Digest of the algorithm."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def frames(self, scene, seed, threads=None):
        """A session that makes frames of the scene."""
        return _HybridFrames(scene, seed, threads)

    def run(self, scene, seed, progress=None):
        """Make a cold frame, as :meth:`eval.methods.realtime.Realtime.run`."""
        return outcome_of(self.frames(scene, seed), RealtimeParams.preset("simple").step)


class _HybridFrames:
    """Two sessions: one for the coarse levels, whose NNF the other refines at the finest."""

    def __init__(self, scene, seed, threads):
        optimized = RealtimeParams.preset("optimized")
        coarse = replace(optimized, iterations=(0, *optimized.iterations))
        self._coarse = Frames(scene, coarse, (), seed, threads)
        patches = RealtimeParams.preset("simple", levels=1, start="vote")
        self._fine = Frames(scene, patches, (), seed, threads)
        self._fine.take()  # once: the finest level reads the style alone
        self.session, self.size = self._fine.session, self._fine.size
        self.source_size = self._fine.source_size

    def frame(self):
        """A cold frame, (H, W, 3) uint8."""
        self._coarse.frame()
        self.session.nnf = self._coarse.session.nnf
        return self.session.frame(warm=True)


@dataclass(frozen=True)
class FewestBuffers:
    """Leave out one buffer, then more, the least missed first, while energy allows it.

    Attributes
    ----------
    method : Realtime
    """

    method: Realtime

    cost = 30.0

    @property
    def name(self):
        """The method's, and what is asked."""
        return f"{self.method.name}, fewest buffers"

    @property
    def code(self):
        """Digest of the algorithm."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, scene, seed, progress=None):
        """Try.

        Parameters
        ----------
        scene : Scene
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The picture of the fewest buffers. The history has a row for each trial: ``left_out``,
            names with commas between, and ``energy``; first all buffers, then each of them left
            out, then one more from row to row.
        """
        begun = time.perf_counter()
        rows = []

        def tried(left_out):
            weights = tuple((name, 0) for name in left_out)
            image = replace(self.method, weights=weights).frames(scene, seed).frame()
            energy = image_energy(scene, image).mean
            rows.append({"left_out": ", ".join(left_out), "energy": energy})
            return image, energy

        image, least = tried(())
        alone = {name: tried((name,))[1] for name in STAGE_BUFFERS}
        ranked = sorted(alone, key=alone.get)
        for count in range(2, len(ranked)):
            other, energy = tried(tuple(ranked[:count]))
            if energy > TOLERATED * least:
                break
            image = other
        return Outcome(image, time.perf_counter() - begun, history=pd.DataFrame(rows))
