"""Pen and ink: layers of hatching, the highlight left white, a loose outline."""

import numpy as np
from skimage.filters import gaussian
from skimage.measure import find_contours

from data_gen.lines import draw_lines
from data_gen.styles.painting import at, noise, palette, scattered, streamlines

_PAPER = np.array((0.975, 0.955, 0.90))
_INK = ((0.07, 0.07, 0.16), (0.16, 0.13, 0.26), (0.34, 0.18, 0.20))


def pen(subject, seed=31):
    """Draw a :class:`Subject`; (H, W, 3) float."""
    rng = np.random.default_rng(seed)
    shape, unit = subject.light.shape, subject.unit
    on_object, on_wall = subject.object > 0.5, subject.wall > 0.5
    light = 0.88 * subject.light + 0.12 * subject.bounce
    darkness = np.where(
        on_object, 0.86 - 0.80 * light, np.where(on_wall, 0.46 - 0.44 * light, 0.78 - 0.80 * light)
    )
    darkness = np.clip(darkness - 2 * subject.shine, 0, 1)
    darkness -= 0.22 * on_object * subject.bounce**2 * (1 - subject.light)
    region = on_object + 2 * on_wall
    layers = []
    # Each layer hatches in one direction what is darker than its threshold.
    for threshold, turn in ((0.16, 0.0), (0.40, 0.55), (0.60, -0.5), (0.74, 1.3)):
        wobble = 0.05 * noise(rng, shape, 60 * unit)
        flat = np.where(on_wall, -0.85 + turn, 0.06 + turn)
        angles = np.where(on_object, subject.form + turn, flat) + wobble
        layers.append(_hatching(rng, darkness, region, angles, threshold, unit))
    layers += _outline(rng, subject, unit)
    picture = draw_lines(np.broadcast_to(_PAPER, (*shape, 3)), layers)
    fibre = gaussian(rng.standard_normal(shape), 0.6)
    return picture * (1 + 0.035 * fibre / fibre.std())[..., None]


def _hatching(rng, darkness, region, angles, threshold, unit):
    """Thin strokes, cut where the tone no longer asks for them; thicker in the dark."""
    starts = scattered(rng, darkness.shape, 15.0 * unit)
    count = len(starts)
    length = unit * 58 * rng.uniform(0.6, 1.5, count)
    lines = streamlines(starts, angles, length, 6, rng.normal(0, 0.035, count))
    lines += rng.normal(0, 0.25 * unit, lines.shape)
    tone = at(darkness, lines) + rng.normal(0, 0.03, (count, 1))
    here = at(region, lines) == at(region, starts)[:, None]
    drawn = (tone > threshold) & here
    pieces = np.stack([lines[:, :-1], lines[:, 1:]], axis=2)[drawn[:, :-1] & drawn[:, 1:]]
    depth = (tone[:, :-1] - threshold)[drawn[:, :-1] & drawn[:, 1:]]
    widths = unit * (1.5 + 2.0 * np.clip(depth, 0, 0.5)) * rng.uniform(0.7, 1.3, len(pieces))
    colours = palette(_INK, rng.uniform(0, 1, len(pieces)) ** 2)
    return pieces, colours, widths, 0.9


def _outline(rng, subject, unit):
    """The object's outline three times over, each time a little beside it and with gaps."""
    layers = []
    for contour in find_contours(gaussian(subject.object, 1.0), 0.5):
        for repeat in range(3):
            points = contour[:: max(int(3 * unit), 1), ::-1]
            drift = np.cumsum(rng.normal(0, 0.32, points.shape), axis=0)
            drift -= np.linspace(0, 1, len(points))[:, None] * drift[-1]
            points = points + unit * (np.clip(drift, -6, 6) + rng.normal(0, 0.2, points.shape))
            lit = at(gaussian(subject.light, 3.0), points)
            pieces = np.stack([points[:-1], points[1:]], axis=1)
            keep = (lit[:-1] < 0.75) | (repeat == 0)
            keep &= np.repeat(rng.uniform(size=len(pieces) // 12 + 1) > 0.22, 12)[: len(pieces)]
            widths = unit * (2.4 - 1.1 * lit[:-1][keep]) * rng.uniform(0.8, 1.2, keep.sum())
            layers.append((pieces[keep], np.tile(_INK[0], (keep.sum(), 1)), widths, 0.9))
    return layers
