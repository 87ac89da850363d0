"""Watercolour on white: the building is shaded, and casts no shadow on the ground."""

import numpy as np

from data_gen.lines import draw_lines
from data_gen.sketches.strokes import layer, paper, ruled, washed


def unshadowed(building, seed=59):
    """Draw a :class:`Building`; (H, W, 3) float."""
    rng = np.random.default_rng(seed)
    unit, shape = building.unit, building.part.shape
    shaded = building.body * building.shade
    violet = np.broadcast_to((0.36, 0.32, 0.52), building.colour.shape)
    picture = washed(rng, paper(rng, shape), building.colour, 0.8 * building.body, unit, spill=4)
    picture = washed(rng, picture, violet, 0.35 * shaded, unit, spill=4)
    lines = ruled(rng, building.lines, unit, 7, 1.0)
    return draw_lines(picture, [layer(rng, lines, 1.2, unit, 0.7)])
