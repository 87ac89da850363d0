"""Image energy: how well patches of the style match a finished image."""

from dataclasses import dataclass

import numpy as np

from eval.number import Number
from stylit_ref import Params
from stylit_ref.metric.packing import ONE
from stylit_ref.stylization.problem import make_synthesis
from stylit_ref.stylization.schedules import propose_commit

ITERATIONS = 30

NUMBERS = {
    "image_energy": Number("image energy", "{:.0f}"),
    "distinct_in_image": Number("distinct in image", "{:.1%}"),
}

DEFINITION = """\
- **image energy**: mean δ of the best match of every interior patch of the finished image, found by
  a converged λ = 0 search: the same question to every method. **distinct in image**: different
  source centres in that field over interior pixels."""


@dataclass(frozen=True)
class ImageEnergy:
    """A converged search at λ = 0 on a finished image.

    Attributes
    ----------
    mean : float
        Mean best-match δ over the interior pixels (a patch radius from the edge).
    distinct : float
        Different source centres over interior pixels.
    """

    mean: float
    distinct: float


def measure(scene, outcome):
    """Both numbers of the finished image."""
    energy = image_energy(scene, outcome.image)
    return {"image_energy": energy.mean, "distinct_in_image": energy.distinct}


def image_energy(scene, image, patch_width=5, seed=1) -> ImageEnergy:
    """Search the best source patch for every patch of an image.

    The metric is always that of the synthesis at λ = 0 and μ = 2 with equal guide weights, so that
    images of different tools can be compared.

    Parameters
    ----------
    scene : Scene
    image : (H_B, W_B, n) uint8
        Shaped like the style.
    patch_width : int
    seed : int

    Returns
    -------
    ImageEnergy
    """
    params = Params(patch_width=patch_width, uniformity=0, levels=1)
    synthesis = make_synthesis(
        scene.style, scene.source_guides, scene.target_guides, params, seed=seed
    )
    level = synthesis.begin_level(1)
    level.set_style(image)
    level.update_moments()
    for iteration in range(1, ITERATIONS + 1):
        propose_commit(level, seed, 1, 1, iteration)
    radius = patch_width // 2
    interior = np.s_[radius:-radius, radius:-radius]
    centres = level.nnf[interior].reshape(-1, 2)
    flat = np.ravel_multi_index(centres.T, scene.style.shape[:2])
    return ImageEnergy(
        mean=float(level.delta[interior].mean() / ONE),
        distinct=np.unique(flat).size / flat.size,
    )
