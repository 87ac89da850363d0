"""A stylized frame."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class FrameResult:
    """A stylized frame.

    Attributes
    ----------
    frame : int
        Its number, from 0.
    name : str
        What the shot calls it.
    image : (H_B, W_B) or (H_B, W_B, n) uint8
        The output B', with the style's channels; with a mask also with alpha, which is 0 there.
    nnf : (H_B, W_B, 2) int32
        For each target pixel the centre ``(y, x)`` of its source patch; -1 where a mask leaves the
        pixel alone.
    """

    frame: int
    name: str
    image: NDArray[np.uint8]
    nnf: NDArray[np.int32]
