"""Whether a point keeps the source pixel that it was taken from."""

import numpy as np

from eval.frame_sets import FrameSet
from eval.motion_paths import landing
from eval.number import Number

NUMBERS = {"kept": Number("NNF kept", "{:.0%}")}

DEFINITION = """\
- **NNF kept**: which share of the points that a neighbouring frame shows is taken there from the
  same source pixel or one of the eight around it, since motion ends between pixels; the mean over
  both directions of every edge."""


def measure(scene, outcome):
    """The share, if the method tells its NNF."""
    if not isinstance(scene, FrameSet) or outcome.nnf is None:
        return {}
    shares = [
        kept(outcome.nnf[to], outcome.nnf[other], motion)
        for (to, other), motion in scene.edges.items()
    ]
    return {"kept": float(np.mean([share for share in shares if share is not None] or [0]))}


def kept(nnf, other, motion):
    """The share of points that keep their source pixel.

    Parameters
    ----------
    nnf, other : (H, W, 2) int32
        Of a frame and of its neighbour.
    motion : Motion
        From the frame to the neighbour.

    Returns
    -------
    float or None
        None if the neighbour shows none of the points.
    """
    y, x, seen = landing(motion)
    if not seen.any():
        return None
    apart = np.abs(nnf[seen] - other[y, x][seen]).max(axis=1)
    return float((apart <= 1).mean())
