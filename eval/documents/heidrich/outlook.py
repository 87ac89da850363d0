"""What the thesis' outlook asks (chapter 7): how few buffers are enough, and a compromise."""

import time
from dataclasses import dataclass, replace

import numpy as np
import pandas as pd

from eval.methods.realtime import Frames, Realtime, outcome_of
from eval.metrics.image_energy import image_energy
from eval.on_processor import OnProcessor
from eval.outcome import Outcome
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.realtime import passes
from stylit_ref.realtime.exemplar import Exemplar
from stylit_ref.realtime.formulae.packed_nnf import places_of
from stylit_ref.realtime.layout import Layout
from stylit_ref.realtime.packing.stage import STAGE_BUFFERS
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.refinement import Refinement, refine, start_level, threads_of_level
from stylit_ref.realtime.target import Target

TOLERATED = 1.02
"""Energy may rise by so much while buffers are left out."""


@dataclass(frozen=True)
class Hybrid(OnProcessor):
    """The optimized method, but for the finest level, which compares patches as the simple one."""

    name = "hybrid"
    cost = 0.2

    def frames(self, scene, seed, threads=None):
        """A session that makes frames of the scene."""
        return _HybridFrames(scene, seed, threads)

    def run(self, scene, seed, progress=None):
        """Make a cold frame, as :meth:`eval.methods.realtime.Realtime.run`."""
        return outcome_of(self.frames(scene, seed), RealtimeParams.preset("simple").step)


class _HybridFrames:
    """The coarse levels as the optimized method has them, then the finest in a session of its own.

    Each level does what either method does there, and nothing else: no picture is blended that the
    next level does not read.
    """

    def __init__(self, scene, seed, threads):
        self._seed, self._threads = seed, threads
        patches = RealtimeParams.preset("simple", levels=1, start="vote")
        fine = Frames(scene, patches, (), seed, threads)
        fine.take()  # once: the finest level reads the style alone
        self.session, self.size, self.source_size = fine.session, fine.size, fine.source_size
        self._buffers, self._packing = fine.target, fine.packing
        channels = len(self._packing.channels)
        layout = Layout(RealtimeParams.preset("optimized"), channels, passes)
        self._refinement = Refinement(layout, (1,) * channels)
        self._exemplar = Exemplar(*self.source_size, layout)
        self._exemplar.set_guides(fine.source_guides)
        self._exemplar.set_style(scene.style)
        self._exemplar.join()
        self._target = Target(*self.size, layout)
        self._stop = np.zeros(1, np.uint8)

    def frame(self):
        """A cold frame, (H, W, 3) uint8."""
        self._packing.pack_into(self._buffers, self._target.view)
        nnf, inputs = self._coarse_levels(), self.session.inputs
        exemplar, target, refinement, _ = inputs
        with using_threads(self._threads):
            refine(exemplar, target, refinement, [nnf], 0, self._seed, self._stop)
            picture = inputs.blended(nnf)
        self.session.nnf = places_of(nnf)
        return picture

    def _coarse_levels(self):
        """The NNF with which the finest level begins."""
        exemplar, target = self._exemplar, self._target
        nnf = [np.empty(grid, np.int32) for grid in target.grids]
        with using_threads(self._threads):
            target.view_changed()
            for level in range(len(nnf) - 1, 0, -1):
                with using_threads(threads_of_level(target, level)):
                    start_level(exemplar, nnf, level, self._seed)
                    refine(exemplar, target, self._refinement, nnf, level, self._seed, self._stop)
            start_level(exemplar, nnf, 0, self._seed)
        return nnf[0]


@dataclass(frozen=True)
class FewestBuffers(OnProcessor):
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
