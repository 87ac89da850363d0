"""What coherence costs: runs in turns, with the time of state files apart."""

import time
from contextlib import contextmanager
from dataclasses import dataclass, replace
from unittest.mock import patch

import numpy as np
import pandas as pd

from eval.device import processor
from eval.methods.views import compile_kernels, stylized
from eval.outcome import Outcome
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.stylization.params import Params
from stylit_ref.views.params import Coherence
from stylit_ref.views.work.work_folder import WorkFolder

_CODE = code_digest(__file__, without=("gpu_cuda",))


@dataclass(frozen=True)
class Costs:
    """Seconds of the processor for all frames, kernels compiled.

    Runs take turns, so that what else the machine does falls on all of them.

    Attributes
    ----------
    params : Params
    coherences : tuple of Coherence
    rounds : int
        The history has the least of so many.
    """

    params: Params
    coherences: tuple[Coherence, ...]
    rounds: int

    @property
    def name(self):
        """What is compared."""
        return f"{self.params.method}, costs"

    @property
    def code(self):
        """Digest of the algorithm."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    @property
    def cost(self):
        """That of all runs."""
        each = 4.0 if self.params.method == "stylit" else 1.0
        return each * self.rounds * len(self.coherences)

    def run(self, scene, seed, progress=None):
        """Stylize the frames again and again.

        Parameters
        ----------
        scene : FrameSet
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The history has a row for each coherence: ``cpu`` in seconds of all threads, without the
            ``files`` of states. The images are the last ones.
        """
        for coherence in self.coherences:
            compile_kernels(scene, self.params, coherence)
        scene = replace(scene, edges=scene.edges_of_strokes)
        begun = time.perf_counter()
        spent = np.full((self.rounds, len(self.coherences), 2), np.inf)
        for turn in spent:
            for number, coherence in enumerate(self.coherences):
                turn[number], images = _cost(scene, self.params, coherence, seed)
        history = pd.DataFrame(spent.min(axis=0), columns=["cpu", "files"])
        return Outcome(images, time.perf_counter() - begun, history=history)


def _cost(scene, params, coherence, seed):
    with _timed_state_files() as files:
        begun = time.process_time()
        results = stylized(scene, params, coherence, seed)
        whole = time.process_time() - begun
    return (whole - sum(files), sum(files)), np.stack([result.image for result in results])


@contextmanager
def _timed_state_files():
    """A list of the seconds of the processor that each reading and writing of a state takes."""
    seconds = []

    def timed(method):
        def call(*arguments):
            begun = time.process_time()
            result = method(*arguments)
            seconds.append(time.process_time() - begun)
            return result

        return call

    with (
        patch.object(WorkFolder, "get", timed(WorkFolder.get)),
        patch.object(WorkFolder, "put", timed(WorkFolder.put)),
    ):
        yield seconds
