"""Pencil: every shadow is one even tone in the render, and parallel hatching on the paper."""

import numpy as np

from data_gen.lines import draw_lines
from data_gen.sketches.strokes import hatching, layer, paper, ruled

_GRAPHITE = np.array((0.22, 0.22, 0.25))


def hatched(building, seed=43):
    """Draw a :class:`Building`; (H, W, 3) float."""
    rng = np.random.default_rng(seed)
    unit, shape = building.unit, building.part.shape
    dark = building.shade > 0.5
    dull = building.body & (building.colour.mean(axis=-1) < 0.62)
    layers = [
        layer(rng, hatching(rng, where, angle, spacing, unit), width, unit, 0.75, _GRAPHITE)
        for where, angle, spacing, width in (
            (dark, -0.95, 9.0, 2.0),
            (dark & building.body, 0.35, 10.0, 1.6),
            (dull, 1.5, 14.0, 1.2),
        )
    ]
    layers.append(layer(rng, ruled(rng, building.lines, unit, 4, 0.6), 1.3, unit, 0.8, _GRAPHITE))
    return draw_lines(paper(rng, shape), layers)
