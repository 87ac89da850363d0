"""What the seams of a texture cost: M of the paper, with the integers of the library."""

import numpy as np

from eval.number import Number
from eval.textures import Texture
from stylit_ref.texture.exemplars import make_exemplars
from stylit_ref.texture.formulae.seam_cost import ONE
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.passes.seam_maps import seam_maps

NUMBERS = {"seam_cost": Number("seam cost", "{:.4f}")}

DEFINITION = """\
- **seam cost**: M a pixel (η = 1000, d = 2) over all neighbours that do not continue each other in
  the exemplar; those across the border do not count, so that textures that do not tile compare. An
  empty picture costs nothing: never judge by it alone."""


def measure(scene, outcome):
    """The seam cost, if the method tells its coordinates."""
    if not isinstance(scene, Texture) or outcome.coordinates is None:
        return {}
    return {"seam_cost": seam_cost(scene.exemplar, outcome.coordinates)}


def seam_cost(exemplar, coordinates):
    """The cost of S, a pixel.

    Parameters
    ----------
    exemplar : (H, W, c) uint8
    coordinates : (h, w, 3) int32
        S: exemplar 0, and y and x in quarters of a pixel.

    Returns
    -------
    float
    """
    params = TextureParams()
    exemplars = make_exemplars([exemplar], 1, fractions=bool((coordinates[..., 1:] % 4).any()))
    maps = np.empty((2, *coordinates.shape[:2]), np.int32)
    seam_maps(
        exemplars.addresses(coordinates), exemplars.colours, exemplars.stride, params.eta,
        params.exponent, *maps,
    )  # fmt: skip
    total = maps[0, :, :-1].sum(dtype=np.int64) + maps[1, :-1].sum(dtype=np.int64)
    return float(total / ONE / maps[0].size)
