"""A few small frames that move, as a user would hand them over."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from small_scene import small_scene

from stylit_ref.views.frames import Edges, Motion, sequence_pairs

EFFORT = {"levels": 3, "votes": 2, "patchmatch_iterations": 2}
"""Values of Params that make runs short."""


class Sliding(NamedTuple):
    """Guides that slide to the right by a pixel a frame, and the motion between frames."""

    style: NDArray[np.uint8]
    sources: list[NDArray[np.uint8]]
    guides: list[list[NDArray[np.uint8]]]
    edges: Edges


def sliding(frames: int = 3, **sizes) -> Sliding:
    """Sizes and channels are those of small_scene."""
    style, sources, targets = small_scene(**sizes)
    guides = [[np.roll(guide, k, axis=1) for guide in targets] for k in range(frames)]
    size = targets[0].shape[:2]
    return Sliding(style, sources, guides, slides(size, frames))


def slides(size: tuple[int, int], frames: int) -> Edges:
    """The motion of each frame into those before and behind it."""

    def motion(to, other):
        field = np.zeros((*size, 2), np.float32)
        field[:, :, 0] = other - to
        return Motion(field, np.ones(size, bool))

    return {pair: motion(*pair) for pair in sequence_pairs(frames)}
