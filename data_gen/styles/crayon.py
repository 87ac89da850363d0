"""Wax crayon: diagonal strokes on grained paper, round ones on the object."""

import numpy as np
from skimage.filters import gaussian

from data_gen.lines import draw_lines
from data_gen.styles.painting import (
    at,
    palette,
    paper_grain,
    scattered,
    streamlines,
)

_OBJECT = ((0.10, 0.06, 0.28), (0.16, 0.16, 0.52), (0.10, 0.38, 0.64), (0.24, 0.66, 0.66),
           (0.66, 0.88, 0.74))  # fmt: skip
_GROUND = ((0.24, 0.05, 0.20), (0.45, 0.08, 0.22), (0.78, 0.20, 0.14), (0.92, 0.42, 0.12),
           (0.97, 0.66, 0.28), (1.00, 0.87, 0.60))  # fmt: skip
_BOUNCE = np.array((0.62, 0.30, 0.42))
_SHINE = np.array((1.0, 0.98, 0.92))
_PAPER = np.array((0.985, 0.97, 0.94))


def crayon(subject, seed=7):
    """Paint a :class:`Subject`; (H, W, 3) float."""
    rng = np.random.default_rng(seed)
    shape, unit = subject.light.shape, subject.unit
    on_object = subject.object > 0.5
    tone, bounced = subject.tone, subject.reflected
    angles = np.where(on_object, 0.75 * subject.form, -0.9)
    layers = []
    for spacing, reach, thickness, opacity in (
        (7.0, 62, 7.0, 0.5), (5.5, 40, 3.4, 0.6), (6.0, 26, 1.8, 0.8)
    ):  # fmt: skip
        starts = scattered(rng, shape, spacing * unit)
        painted = at(on_object, starts)
        count = len(starts)
        length = unit * reach * rng.uniform(0.5, 1.4, count) * np.where(painted, 0.55, 1.3)
        lines = streamlines(starts, angles, length, 2, rng.normal(0, 0.16, count))
        shade = np.clip(at(tone, starts) + rng.normal(0, 0.06, count), 0, 1)
        colours = np.where(painted[:, None], palette(_OBJECT, shade), palette(_GROUND, shade))
        reflected = painted * at(bounced, starts) ** 2
        colours += 0.6 * reflected[:, None] * (_BOUNCE - colours)
        colours += (at(subject.shine, starts) > 0.45)[:, None] * (_SHINE - colours)
        colours += rng.normal(0, 0.05, (count, 3))
        # An artist stays roughly inside the outline: most strokes that cross it are lifted.
        inside = (at(on_object, lines[:, [0, -1]]) == painted[:, None]).all(axis=1)
        keep = inside | (rng.uniform(size=count) < 0.05)
        widths = unit * thickness * rng.uniform(0.6, 1.3, keep.sum())
        layers.append((lines[keep], colours[keep], widths, opacity))
    picture = draw_lines(np.broadcast_to(_PAPER, (*shape, 3)), layers)
    # Wax skips the valleys of the paper, more so where little of it was laid on.
    skipped = paper_grain(rng, shape) < 0.05 + 0.11 * tone * (subject.shine < 0.3)
    skipped = 0.75 * gaussian(skipped.astype(float), 0.4)[..., None]
    return picture + skipped * (_PAPER - picture)
