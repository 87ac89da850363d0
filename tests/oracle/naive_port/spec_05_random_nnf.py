"""5. Random NNF."""

import numpy as np

from .spec_01_names import assigned_pixels, radius_of, source_shape_of
from .spec_04_random_numbers import RANDOM_NNF, below, draw_grid, make_stream


def random_nnf(nnf, source_shape, radius, seed, level):
    """Assign a random centre to every pixel that is not at -1."""
    height, width = nnf.shape[:2]
    words = draw_grid(make_stream(RANDOM_NNF, seed, level), height, width, 0)
    y = radius + below(words[..., 0], source_shape[0] - 2 * radius)
    x = radius + below(words[..., 1], source_shape[1] - 2 * radius)
    return np.where(assigned_pixels(nnf)[..., None], np.stack([y, x], axis=-1), -1)


def stage_random_nnf(p, a):
    """Do stage random_nnf."""
    shape = source_shape_of(p)
    return {"nnf": random_nnf(a["nnf"], shape, radius_of(p), int(p["seed"]), p["level"])}


STAGES = {"random_nnf": stage_random_nnf}
