"""Washes that dry in blotches, with wandering borders and a few pale lines.

Blotches lie where they will, as strokes do, but no edge of them is steep. What coherence leaves of
a difference grows with the steepness of the paint: ink is steep, this is not.
"""

import numpy as np

from data_gen.lines import draw_lines
from data_gen.sketches import strokes
from data_gen.styles.painting import noise

_SHADOW = np.array((0.34, 0.33, 0.48))
_BLOTCH = 10
"""Thin strokes across."""
_PENCIL = np.array((0.38, 0.36, 0.40))


def washed(building, seed=61):
    """Draw a :class:`Building`; (H, W, 3) float."""
    rng = np.random.default_rng(seed)
    unit, shape = building.unit, building.part.shape
    is_something = building.part >= 0
    bright = np.clip(1.12 * building.colour, 0, 1)
    violet = np.broadcast_to(_SHADOW, bright.shape)
    picture = strokes.paper(rng, shape)
    for colour, amount, spill in (
        (bright, 0.62 * is_something, 8),
        (bright, 0.30 * building.body, 5),
        (violet, 0.40 * is_something * building.shade, 7),
    ):
        amount = amount * (1 + 0.25 * noise(rng, shape, _BLOTCH * unit))
        picture = strokes.washed(rng, picture, colour, amount, unit, spill)
    outlines = building.lines[building.is_outline]
    layers = [
        strokes.layer(rng, strokes.ruled(rng, lines, unit, past, drift), 1.6, unit, 0.5, _PENCIL)
        for lines, past, drift in ((building.lines, 5, 1.0), (outlines, 14, 2.5))
    ]
    return draw_lines(picture, layers)
