"""The result of a method on a scene."""

from dataclasses import dataclass, field

import numpy as np
import pandas as pd


@dataclass(frozen=True)
class Outcome:
    """A finished image, and what else the method can tell about it.

    Attributes
    ----------
    image : (H_B, W_B, n) uint8
    seconds : float
        Wall time of the method alone, without compilation.
    nnf : (H_B, W_B, 2) int32, optional
        The source pixel that each pixel was taken from.
    omega : (H_A, W_A) int32, optional
        How often each pixel of the source was used.
    guide_map : (H_B, W_B) bool, optional
        G of the finest level.
    levels : tuple of (H, W, n) uint8
        The image of every pyramid level, the coarsest first.
    stages : dict of str to float
        Seconds by stage.
    history : pandas.DataFrame
        A row for each step: of a search with ``delta`` and, if the method has it,
        ``penalization``.
    coordinates : (H, W, 3) int32, optional
        S of a texture: exemplar, y and x in quarters of a pixel.
    """

    image: np.ndarray
    seconds: float
    nnf: np.ndarray | None = None
    omega: np.ndarray | None = None
    guide_map: np.ndarray | None = None
    levels: tuple[np.ndarray, ...] = ()
    stages: dict[str, float] = field(default_factory=dict)
    history: pd.DataFrame = field(default_factory=pd.DataFrame)
    coordinates: np.ndarray | None = None

    @property
    def processor_seconds(self):
        """Seconds of the processor, all threads together; by the clock if the method has no others.

        Those of a GPU and of another program are by the clock.
        """
        return self.stages.get("cpu", self.seconds)
