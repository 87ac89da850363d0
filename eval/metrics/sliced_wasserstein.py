"""Whether a texture has the patches of its exemplar, and as often."""

import numpy as np
from skimage.util import view_as_windows

from eval.number import Number
from eval.textures import Texture

WIDTH = 7
PATCHES, OF_EXEMPLAR = 6000, 12000
DIRECTIONS = 128

NUMBERS = {"sw": Number("sw", "{:.2f}")}

DEFINITION = """\
- **sw**: sliced Wasserstein distance between the 7x7 patches of the texture and of the exemplar
  (6000 and 12000 of them, 128 directions), in 8-bit steps. What is missing or too frequent raises
  it; where things lie does not count. An exemplar against itself has 0.3 to 0.9."""


def measure(scene, outcome):
    """The distance of a texture to its exemplar."""
    if not isinstance(scene, Texture):
        return {}
    return {"sw": sliced_wasserstein(outcome.image, scene.exemplar)}


def sliced_wasserstein(image, exemplar):
    """The mean, over directions, of the first Wasserstein distance along them.

    Parameters
    ----------
    image, exemplar : (H, W, c) uint8

    Returns
    -------
    float
        In 8-bit steps. Since patches are random samples, it stays above 0.
    """
    import ot  # imported late: it takes most of a second, and old numbers need none

    clouds = _patches(image, PATCHES, 1), _patches(exemplar, OF_EXEMPLAR, 2)
    return float(ot.sliced_wasserstein_distance(*clouds, n_projections=DIRECTIONS, seed=1, p=1))


def _patches(image, count, seed):
    windows = view_as_windows(image, (WIDTH, WIDTH, image.shape[2]))[:, :, 0]
    rng = np.random.default_rng(seed)
    y, x = (rng.integers(0, side, count) for side in windows.shape[:2])
    return windows[y, x].reshape(count, -1).astype(float)
