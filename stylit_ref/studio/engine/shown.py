"""A picture that was shown, and what it was made of."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.field import Field
from stylit_ref.files.realtime_field import RealtimeField
from stylit_ref.studio.engine.events import Which
from stylit_ref.studio.engine.parameters import Settings
from stylit_ref.studio.engine.scene import Scene


@dataclass(frozen=True, eq=False)
class Shown:
    """A picture that was shown.

    Attributes
    ----------
    which : str
        As of :class:`~stylit_ref.studio.engine.events.Picture`.
    image : (H_B, W_B, 3) uint8
    style : (H_A, W_A, 3) uint8
    field : Field or RealtimeField
        Through which the style gives the image.
    scene : Scene
    step : int
        Of its target.
    settings : Settings
    weighs_buffers : bool
        Whether the weights of buffers counted.
    """

    which: Which
    image: NDArray[np.uint8]
    style: NDArray[np.uint8]
    field: Field | RealtimeField
    scene: Scene
    step: int
    settings: Settings
    weighs_buffers: bool = True
