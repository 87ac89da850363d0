"""16. A lower bound of delta."""

import numpy as np

from .spec_01_names import assigned_pixels, offsets, radius_of, target_grid
from .spec_03_metric import patch_values, usable_centres

MOMENTS = {
    3: ((1, 1, 1), (-1, 0, 1), (1, -2, 1)),
    5: ((1, 1, 1, 1, 1), (-2, -1, 0, 1, 2), (2, -1, -2, -1, 2)),
}
GUIDE_DEGREES = ((0, 0),)
STYLE_DEGREES = ((0, 0), (0, 1), (1, 0), (0, 2), (2, 0), (1, 1))


def channel_bound(source, target, weight, nnf, radius, degrees):
    """Bound the part of one channel by its moments."""
    inner = min(2 * radius + 1, 5)
    pixels = np.stack(target_grid(*nnf.shape[:2]), axis=-1)
    centres = usable_centres(nnf, radius)
    bound = np.zeros(nnf.shape[:2], np.int64)
    for v, h in degrees:
        p_v, p_h = MOMENTS[inner][v], MOMENTS[inner][h]
        difference, norm = 0, 0
        for dy, dx in offsets(inner // 2):
            factor = p_v[dy + inner // 2] * p_h[dx + inner // 2]
            ours, theirs = patch_values(source, target, pixels, centres, dy, dx)
            difference = difference + factor * (ours - theirs)
            norm += factor * factor
        bound += (8 * int(weight)) // norm * difference * difference
    return bound


def lower_bound(source, target, weights, nnf, radius, n_g):
    """Bound 8 delta of the assignments from below; 0 at -1."""
    total = np.zeros(nnf.shape[:2], np.int64)
    for c, weight in enumerate(weights):
        degrees = GUIDE_DEGREES if c < n_g else STYLE_DEGREES
        total += channel_bound(source[..., c], target[..., c], weight, nnf, radius, degrees)
    return np.where(assigned_pixels(nnf), total, 0)


def stage_lower_bound(p, a):
    """Do stage lower_bound."""
    bound = lower_bound(
        a["source"], a["target"], a["weights"], a["nnf"], radius_of(p), p["guide_channels"]
    )
    return {"bound": bound}


STAGES = {"lower_bound": stage_lower_bound}
