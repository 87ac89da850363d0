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
    "median_energy": Number("median energy", "{:.0f}"),
    "distinct_in_image": Number("distinct in image", "{:.1%}"),
    "energy_apart": Number("energy where masks differ", "{:.0f}"),
    "energy_alike": Number("energy where masks agree", "{:.0f}"),
}

DEFINITION = """\
- **image energy**: mean δ of the best match of every interior patch of the finished image, found by
  a converged λ = 0 search: the same question to every method. **distinct in image**: different
  source centres in that field over interior pixels. **median energy**: the median of those δ.
  **energy where masks differ**: their mean over pixels whose IDMASK or LIGHTMASK is not the
  source's in the same place (Heidrich 2017, 6.2.1), for scenes that have both buffers."""


@dataclass(frozen=True)
class ImageEnergy:
    """A converged search at λ = 0 on a finished image.

    Attributes
    ----------
    delta : (H_B - w + 1, W_B - w + 1) float64
        Best-match δ of the interior pixels (a patch radius from the edge).
    distinct : float
        Different source centres over interior pixels.
    """

    delta: np.ndarray
    distinct: float

    @property
    def mean(self):
        """Mean δ."""
        return float(self.delta.mean())


def measure(scene, outcome):
    """All numbers of the finished image."""
    energy = image_energy(scene, outcome.image)
    numbers = {
        "image_energy": energy.mean,
        "median_energy": float(np.median(energy.delta)),
        "distinct_in_image": energy.distinct,
    }
    apart = masks_apart(scene)
    if apart is not None:
        margin = (apart.shape[0] - energy.delta.shape[0]) // 2
        inner = apart[margin : apart.shape[0] - margin, margin : apart.shape[1] - margin]
        for name, region in (("energy_apart", inner), ("energy_alike", ~inner)):
            if region.any():
                numbers[name] = float(energy.delta[region].mean())
    return numbers


def masks_apart(scene):
    """Where source and target differ in what they show: the object, the ground, light or shadow.

    Parameters
    ----------
    scene : Scene

    Returns
    -------
    (H, W) bool, or None
        None if the scene lacks a mask, or its target is not as large as its source.
    """
    pairs = [scene.buffers.get(name) for name in ("IDMASK", "LIGHTMASK")]
    if None in pairs or any(source.shape != target.shape for source, target in pairs):
        return None
    return np.any([((s > 127) != (t > 127)).any(axis=2) for s, t in pairs], axis=0)


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
        delta=level.delta[interior] / ONE,
        distinct=np.unique(flat).size / flat.size,
    )
