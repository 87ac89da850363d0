"""Whether the background goes on where the source has something else: Heidrich 2017, Fig. 24a."""

import numpy as np

from eval.metrics.nearest_patch import (
    LARGEST_CLOUD,
    SAMPLES,
    WIDTH,
    distance_to_nearest,
    patches,
    some_of,
)
from eval.metrics.wrong_things import BACKGROUND, views_of
from eval.number import Number

NUMBERS = {"background": Number("background broken", "{:.2f}")}

DEFINITION = """\
- **background broken**: RMS difference, in 8-bit steps, from 7x7 patches of the background to the
  nearest of the style's background: where the source shows something else in their place, less
  where it shows background too. 0 if the background goes on as well as elsewhere."""


def measure(scene, outcome):
    """The number, if the scene's masks are known and source and target have one size."""
    views = views_of(scene)
    if views is None or views[0].labels.shape != views[1].labels.shape:
        return {}
    source, target = (view.labels == BACKGROUND for view in views)
    broken = background_broken(outcome.image, scene.style, source, target)
    return {} if broken is None else {"background": broken}


def background_broken(image, style, source, target):
    """How much worse the background's patches are where the source had something else.

    Parameters
    ----------
    image, style : (H, W, n) uint8
    source, target : (H, W) bool
        Their backgrounds.

    Returns
    -------
    float or None
        None if one of the two kinds of place does not occur.
    """
    rng = np.random.default_rng(1)
    radius = WIDTH // 2
    middle = np.s_[radius:-radius, radius:-radius]
    source, target = source[middle].ravel(), target[middle].ravel()
    cloud = patches(style)[source]
    places = [patches(image)[where] for where in (target & ~source, target & source)]
    if len(cloud) < 3 or not all(map(len, places)):
        return None
    cloud = some_of(cloud, LARGEST_CLOUD, rng)
    uncovered, elsewhere = (
        distance_to_nearest(some_of(place, SAMPLES, rng), cloud) for place in places
    )
    return uncovered - elsewhere
