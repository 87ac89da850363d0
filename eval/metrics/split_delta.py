"""δ of a finished image, guides and style apart."""

from dataclasses import replace

import numpy as np

from eval.number import Number
from stylit_ref import passes
from stylit_ref.metric.packing import ONE, make_packing
from stylit_ref.stylization.level import Level
from stylit_ref.stylization.params import Params

NUMBERS = {"guides": Number("δ, guides", "{:.0f}"), "style": Number("δ, style", "{:.0f}")}

DEFINITION = """\
- **δ, guides** and **δ, style**: mean over all target patches of the finished image, in squared
  8-bit steps (thesis 2.1)."""


def measure(scene, outcome):
    """Both parts, where it is known what was taken from where."""
    if outcome.nnf is None:
        return {}
    guides, style = split_delta(scene, outcome.image, outcome.nnf)
    return {"guides": guides, "style": style}


def split_delta(scene, image, nnf, patch_width=5):
    """Mean δ between the target patches of a finished image and their source patches.

    Parameters
    ----------
    scene : Scene
    image : (H_B, W_B, n) uint8
    nnf : (H_B, W_B, 2) int32
    patch_width : int

    Returns
    -------
    guides, style : float
        Their sum is the mean δ, in squared 8-bit steps.
    """
    both, style = (_mean_delta(scene, image, nnf, patch_width, mu) for mu in (2.0, 0.0))
    return both - style, style


def _mean_delta(scene, image, nnf, patch_width, guide_influence):
    params = replace(Params(), patch_width=patch_width, guide_influence=guide_influence)
    channels = [guide.shape[2] for guide in scene.source_guides]
    weights = [1.0] * len(channels)
    packing = make_packing(channels, scene.style.shape[2], guide_influence, weights)
    source = packing.pack(scene.source_guides, scene.style)
    target = packing.pack(scene.target_guides, image)
    level = Level(passes, packing, params, source, target, np.ones(nnf.shape[:2], bool))
    level.nnf[:] = nnf
    level.update_similarity()
    return float(level.delta.mean() / ONE)
