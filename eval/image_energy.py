"""Image energy: how well a finished image is made of patches of the style."""

from dataclasses import dataclass

import numpy as np

from eval.scenes import Scene
from stylit_ref import Params
from stylit_ref.metric.packing import ONE
from stylit_ref.stylization.problem import make_synthesis
from stylit_ref.stylization.schedules import propose_commit

ITERATIONS = 30


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


def image_energy(scene: Scene, image, patch_width=5, seed=1) -> ImageEnergy:
    """Search the best source patch for every patch of an image.

    The metric is that of the synthesis at λ = 0 and μ = 2, all guides alike, whoever
    made the image and however, so that tools can be compared.

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
