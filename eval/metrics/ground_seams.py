"""Whether flat ground shows where pieces of the painting meet."""

import numpy as np
from scipy.ndimage import binary_erosion

from eval.metrics.wrong_things import BACKGROUND, views_of
from eval.number import Number

RADIUS = 2
"""Of a patch."""

MARGIN = 12
"""Pixels from the ground's border that are left out."""

NUMBERS = {"ground_seams": Number("seams on flat ground", "{:.1f}")}

DEFINITION = """\
- **seams on flat ground**: on the background, away from everything else, the RMS difference in
  8-bit steps between 5x5 patches of the picture and the patches that they were taken from. Inside a
  piece of the painting it is 0; where pieces meet that do not continue each other it is not."""


def measure(scene, outcome):
    """The number, if the scene's masks and the NNF are known and there is such ground."""
    views = views_of(scene)
    if views is None or outcome.nnf is None:
        return {}
    ground = flat_ground(views[1].labels)
    if not ground.any():
        return {}
    found = misfits(outcome.image, scene.style, outcome.nnf, ground)
    return {"ground_seams": float(np.sqrt(found.mean()))}


def flat_ground(labels):
    """Background away from everything else, (H, W) bool."""
    return binary_erosion(labels == BACKGROUND, iterations=MARGIN, border_value=0)


def misfits(image, style, nnf, ground):
    """How far patches of a picture are from those that they were taken from.

    Parameters
    ----------
    image : (H_B, W_B, n) uint8
    style : (H_A, W_A, n) uint8
    nnf : (H_B, W_B, 2) int32
    ground : (H_B, W_B) bool
        The patches' centres, at least a radius from the border.

    Returns
    -------
    (N,) float
        Mean squares of 8-bit steps, of the ground's pixels in their order.
    """
    places = np.argwhere(ground)
    sources = nnf[ground].clip(RADIUS, np.array(style.shape[:2]) - 1 - RADIUS)
    total = np.zeros(len(places))
    for offset in np.ndindex(2 * RADIUS + 1, 2 * RADIUS + 1):
        ours, theirs = (
            picture[tuple((at + offset - RADIUS).T)].astype(np.int32)
            for picture, at in ((image, places), (style, sources))
        )
        total += ((ours - theirs) ** 2).mean(axis=1)
    return total / (2 * RADIUS + 1) ** 2
