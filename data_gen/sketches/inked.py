"""Ink over a pale wash: edges drawn twice, well past the corners and beside the geometry."""

import numpy as np

from data_gen.lines import draw_lines
from data_gen.sketches.strokes import layer, paper, ruled, washed


def inked(building, seed=41):
    """Draw a :class:`Building`; (H, W, 3) float."""
    rng = np.random.default_rng(seed)
    unit, shape = building.unit, building.part.shape
    amount = np.where(building.body, 0.55, 0.0) + 0.30 * building.ground * building.shade
    picture = washed(rng, paper(rng, shape), building.colour, amount, unit, spill=6)
    outline = building.is_outline
    layers = [
        layer(rng, ruled(rng, building.lines, unit, 9, 1.0), 1.3, unit, 0.75),
        layer(rng, ruled(rng, building.lines[~outline], unit, 16, 2.2), 0.9, unit, 0.5),
        layer(rng, ruled(rng, building.lines[outline], unit, 34, 2.0), 2.4, unit, 0.85),
        layer(rng, ruled(rng, building.lines[outline], unit, 46, 5.0), 1.6, unit, 0.7),
    ]
    return draw_lines(picture, layers)
