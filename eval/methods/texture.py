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
    """

    name: str = "default"
    params: TextureParams = field(default_factory=TextureParams)

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
            The history has a row for every iteration, with its ``seconds``.
        """
        TextureSession([texture.exemplar], texture.shape, self.params).step()
        clock = [time.perf_counter()]
        result = synthesize_texture(
            texture.exemplar, texture.shape, self.params, seed=seed,
            progress=lambda iteration: clock.append(time.perf_counter()),
        )  # fmt: skip
        seconds = time.perf_counter() - clock[0]
        history = pd.DataFrame([asdict(step) for step in result.history])
        history["seconds"] = np.diff(clock)  # the first has white noise, too
        return Outcome(
            image=result.image,
            seconds=seconds,
            history=history,
            coordinates=result.coordinates,
        )
