"""Texture synthesis of the library itself."""

import time
from dataclasses import asdict, dataclass, field

import numpy as np
import pandas as pd

from eval.device import processor
from eval.outcome import Outcome
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession
from stylit_ref.texture.synthesize import synthesize_texture

_CODE = code_digest(__file__, without=("gpu_cuda",))


@dataclass(frozen=True)
class TextureSynthesis:
    """A run of :func:`stylit_ref.texture.synthesize.synthesize_texture`.

    Attributes
    ----------
    name : str
        What reports call it.
    params : TextureParams
    repeats : int
        How often it is run. Of several times of an iteration the least is that of a quiet machine.
    alone : bool
        Whether nothing else may run, since its times count.
    """

    name: str = "default"
    params: TextureParams = field(default_factory=TextureParams)
    repeats: int = 1
    alone: bool = False

    cost = 1.0

    @property
    def code(self):
        """Digest of the algorithm."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, texture, seed, progress=None):
        """Synthesize a texture; the kernels are compiled first.

        Parameters
        ----------
        texture : Texture
        seed : int
        progress : callable, optional
            Not called: a run takes a second.

        Returns
        -------
        Outcome
            The history has a row for every iteration, with its ``seconds`` and
            ``processor_seconds``, those of all threads; the stage ``cpu`` is the sum of these.
        """
        TextureSession([texture.exemplar], texture.shape, self.params).step()
        times = []
        for _ in range(self.repeats):
            clock = [_now()]
            result = synthesize_texture(
                texture.exemplar, texture.shape, self.params, seed=seed,
                progress=lambda iteration, clock=clock: clock.append(_now()),
            )  # fmt: skip
            times.append(np.diff([*clock, _now()], axis=0))
        seconds, cpu = np.min([each.sum(axis=0) for each in times], axis=0).tolist()
        history = pd.DataFrame([asdict(step) for step in result.history])
        least = np.min(times, axis=0)[:-1]  # the first has white noise, too
        history["seconds"], history["processor_seconds"] = least.T
        return Outcome(
            image=result.image,
            seconds=seconds,
            stages={"cpu": cpu},
            history=history,
            coordinates=result.coordinates,
        )


def _now():
    """Wall seconds, and those of all processors."""
    return time.perf_counter(), time.process_time()
