"""How similar the patches of an image are, as a whole, to those of the style."""

import numpy as np
from skimage.util import view_as_windows

from eval.number import Number

PATCHES = 10000
PROJECTIONS = 64

NUMBERS = {"patches": Number("patch distance", "{:.2f}")}

DEFINITION = """\
- **patch distance**: sliced Wasserstein distance between the 5x5 patches of the output and of the
  style, 10000 of each, 64 directions, in 8-bit steps: whether there are the same strokes, and as
  often."""


def measure(scene, outcome):
    """The patch distance of the finished image."""
    return {"patches": patch_distance(outcome.image, scene.style)}


def patch_distance(image, style, patch_width=5, seed=0):
    """Sliced Wasserstein distance between the patches of an image and those of the style.

    Wash-out and repetition change which patches occur and how often. The positions of patches do
    not count.

    Parameters
    ----------
    image, style : (H, W, n) uint8
        They may differ in size.
    patch_width : int
    seed : int
        Seed of the random patches, at most 10000 of each image, and of the 64 directions.

    Returns
    -------
    float
        Root mean square over the directions, in 8-bit steps; 0 for the same image. For different
        images it stays above 0, since the patches are random samples.
    """
    import ot  # imported late: it takes most of a second, and old numbers need none

    clouds = (_patches(each, patch_width, np.random.default_rng(seed)) for each in (image, style))
    return float(ot.sliced_wasserstein_distance(*clouds, n_projections=PROJECTIONS, seed=seed))


def _patches(image, patch_width, rng):
    windows = view_as_windows(image, (patch_width, patch_width, image.shape[2]))
    windows = windows.reshape(-1, patch_width**2 * image.shape[2])
    if len(windows) > PATCHES:
        windows = windows[rng.choice(len(windows), PATCHES, replace=False)]
    return windows.astype(float)
