"""δ of a finished image, in two parts: guides and style."""

from eval.number import Number
from stylit_ref import Params
from stylit_ref.metric.packing import ONE
from stylit_ref.stylization.problem import make_synthesis

NUMBERS = {"guides": Number("δ, guides", "{:.0f}"), "style": Number("δ, style", "{:.0f}")}

DEFINITION = """\
- **δ, guides** and **δ, style**: mean over all target patches of the finished image, in squared
  8-bit steps (thesis 2.1)."""


def measure(scene, outcome):
    """Both parts, if the method tells its NNF."""
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
    params = Params(
        patch_width=patch_width, guide_influence=guide_influence, uniformity=0, levels=1
    )
    level = make_synthesis(
        scene.style, scene.source_guides, scene.target_guides, params
    ).begin_level(1)
    level.nnf[:] = nnf
    level.set_style(image)
    return float(level.delta.mean() / ONE)
