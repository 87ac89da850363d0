"""Markers: broad strokes that begin in one part and run on over its neighbours."""

import numpy as np

from data_gen.lines import draw_lines
from data_gen.sketches.strokes import layer, paper, ruled
from data_gen.styles.painting import at, scattered, streamlines

_DIRECTIONS = (-0.9, -0.35, 0.15, -1.2, 0.5, 0.04)
"""Of the strokes in each part, in radians: neighbours differ."""


def marker(building, seed=47):
    """Draw a :class:`Building`; (H, W, 3) float."""
    rng = np.random.default_rng(seed)
    unit, shape = building.unit, building.part.shape
    angles = np.array(_DIRECTIONS)[building.part % len(_DIRECTIONS)]
    layers = []
    for spacing, reach, width, opacity in ((12, 110, 16, 0.45), (10, 70, 9, 0.5)):
        starts = scattered(rng, shape, spacing * unit)
        starts = starts[at(building.part, starts) >= 0]
        count = len(starts)
        # The direction is that of where a stroke began: it goes straight on, whatever it crosses.
        bend = at(angles, starts) + rng.normal(0, 0.05, count)
        length = unit * reach * rng.uniform(0.6, 1.4, count)
        lines = streamlines(starts, np.zeros(shape), length, 1, bend)
        colours = 0.15 + 0.95 * at(building.colour, starts) + rng.normal(0, 0.02, (count, 1))
        layers.append((lines, colours, width * unit * rng.uniform(0.8, 1.2, count), opacity))
    layers.append(layer(rng, ruled(rng, building.lines, unit, 8, 0.8), 1.5, unit, 0.8))
    return draw_lines(paper(rng, shape), layers)
