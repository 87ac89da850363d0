"""Whether patches were still taken from where the guides are alike."""

import numpy as np

from eval.frame_sets import FrameSet
from eval.number import Number

NUMBERS = {"guide_error": Number("error of guides", "{:.2f}")}

DEFINITION = """\
- **error of guides**: mean absolute difference between the guides of a target pixel and those of
  the source pixel that it was taken from, in 8-bit steps, over channels and frames; lower is
  better."""


def measure(scene, outcome):
    """The difference of guides, if the method tells its NNF."""
    if not isinstance(scene, FrameSet) or outcome.nnf is None:
        return {}
    frames = zip(outcome.nnf, scene.guides, strict=True)
    return {
        "guide_error": float(
            np.mean([guide_error(nnf, scene.source_guides, guides) for nnf, guides in frames])
        )
    }


def guide_error(nnf, source_guides, guides):
    """Mean difference of the guides of a frame.

    Parameters
    ----------
    nnf : (H, W, 2) int32
    source_guides : sequence of (H_A, W_A, c) uint8
    guides : sequence of (H, W, c) uint8

    Returns
    -------
    float
        All channels of all guides count alike.
    """
    source = np.concatenate([np.atleast_3d(guide) for guide in source_guides], axis=2)
    target = np.concatenate([np.atleast_3d(guide) for guide in guides], axis=2)
    return float(np.abs(source[nnf[..., 0], nnf[..., 1]].astype(int) - target).mean())
