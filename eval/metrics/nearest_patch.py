"""Whether every patch of a texture is one of the exemplar's, and every one of those is there."""

import numba
import numpy as np
from scipy.spatial import cKDTree
from skimage.util import view_as_windows

from eval.number import Number
from eval.textures import Texture

WIDTH = 7
SAMPLES = 1500
COMPONENTS = 24
LARGEST_CLOUD = 65536

NUMBERS = {
    "novelty": Number("novelty", "{:.2f}"),
    "omission": Number("omission", "{:.2f}"),
}

DEFINITION = """\
- **novelty**: RMS difference from 1500 7x7 patches of the texture to the nearest of the exemplar's,
  in 8-bit steps: what is new in it, such as seams. **omission**: the same from patches of the
  exemplar to the nearest of the texture's: what is missing."""


def measure(scene, outcome):
    """Both distances of a texture."""
    if not isinstance(scene, Texture):
        return {}
    return {
        "novelty": nearest_patch(outcome.image, scene.exemplar),
        "omission": nearest_patch(scene.exemplar, outcome.image),
    }


def nearest_patch(image, other):
    """Mean RMS difference from patches of an image to the nearest patch of another.

    Parameters
    ----------
    image, other : (H, W, c) uint8

    Returns
    -------
    float
        In 8-bit steps.
    """
    rng = np.random.default_rng(1)
    return distance_to_nearest(*(
        some_of(patches(each), most, rng)
        for each, most in ((image, SAMPLES), (other, LARGEST_CLOUD))
    ))  # fmt: skip


def distance_to_nearest(wanted, cloud):
    """Mean RMS difference from patches to the nearest of a cloud of patches.

    Candidates are the three nearest by the cloud's principal components.

    Parameters
    ----------
    wanted, cloud : (N, n) float

    Returns
    -------
    float
    """
    mean = cloud.mean(axis=0)
    axes = np.linalg.eigh(np.cov(cloud, rowvar=False))[1][:, -COMPONENTS:]
    threads = numba.get_num_threads()  # a run that has others beside it has one
    _, nearest = cKDTree((cloud - mean) @ axes).query((wanted - mean) @ axes, k=3, workers=threads)
    squares = ((cloud[nearest] - wanted[:, None]) ** 2).mean(axis=2)
    return float(np.sqrt(squares.min(axis=1)).mean())


def patches(image):
    """All 7x7 patches of an image, (N, 49 c), in the order of their middles."""
    windows = view_as_windows(image, (WIDTH, WIDTH, image.shape[2]))
    return windows.reshape(-1, WIDTH**2 * image.shape[2])


def some_of(windows, most, rng):
    """At most so many rows, drawn at random, as float."""
    if len(windows) > most:
        windows = windows[rng.choice(len(windows), most, replace=False)]
    return windows.astype(float)
