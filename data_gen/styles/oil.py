"""Oil: broad bristle strokes that follow the form, thick where the light is."""

import numpy as np
from skimage.filters import gaussian

from data_gen.lines import draw_lines
from data_gen.styles.painting import at, noise, palette, scattered, streamlines

_OBJECT = ((0.16, 0.07, 0.20), (0.36, 0.10, 0.20), (0.66, 0.20, 0.12), (0.86, 0.46, 0.13),
           (0.97, 0.78, 0.34))  # fmt: skip
_GROUND = ((0.16, 0.20, 0.30), (0.30, 0.36, 0.42), (0.52, 0.55, 0.50), (0.76, 0.74, 0.62),
           (0.92, 0.89, 0.78))  # fmt: skip
_WALL = ((0.12, 0.26, 0.32), (0.20, 0.40, 0.44), (0.36, 0.55, 0.55), (0.60, 0.71, 0.66))
_BOUNCE = np.array((0.42, 0.36, 0.52))
_SHINE = np.array((1.0, 0.97, 0.90))
_BRISTLES = 9


def oil(subject, seed=11):
    """Paint a :class:`Subject`; (H, W, 3) float."""
    rng = np.random.default_rng(seed)
    shape, unit = subject.light.shape, subject.unit
    on_object, on_wall = subject.object > 0.5, subject.wall > 0.5
    tone, bounced = subject.tone, subject.reflected
    swirl = 0.9 * noise(rng, shape, 260 * unit) - 0.4
    angles = np.where(on_object, subject.form, np.where(on_wall, swirl, 0.12 * swirl))
    region = on_object + 2 * on_wall
    layers = []
    for spacing, reach, thickness in ((20, 130, 40), (13, 80, 24), (9, 46, 13)):
        starts = scattered(rng, shape, spacing * unit)
        painted, walled = at(on_object, starts), at(on_wall, starts)
        count = len(starts)
        length = unit * reach * rng.uniform(0.6, 1.3, count) * np.where(painted, 0.7, 1.2)
        lines = streamlines(starts, angles, length, 5, rng.normal(0, 0.1, count))
        shade = np.clip(at(tone, starts) + rng.normal(0, 0.05, count), 0, 1)
        colours = np.where(walled[:, None], palette(_WALL, shade), palette(_GROUND, shade))
        colours = np.where(painted[:, None], palette(_OBJECT, shade), colours)
        reflected = painted * at(bounced, starts) ** 2
        colours += 0.7 * reflected[:, None] * (_BOUNCE - colours)
        colours += rng.normal(0, 0.035, (count, 3))
        ends = at(region, lines[:, [0, -1]]) == at(region, starts)[:, None]
        keep = ends.all(axis=1) | (rng.uniform(size=count) < 0.04)
        layers += _bristles(rng, lines[keep], colours[keep], unit * thickness)
    rows, columns = np.nonzero(subject.shine > 0.5)
    if rows.size:
        chosen = rng.integers(0, rows.size, 40)
        dabs = np.stack([columns[chosen], rows[chosen]], axis=-1)
        lines = streamlines(dabs, angles, unit * rng.uniform(10, 34, 40), 3, rng.normal(0, 0.3, 40))
        shades = _SHINE + rng.normal(0, 0.03, (40, 1))
        layers += _bristles(rng, lines, shades, unit * 9)
    picture = draw_lines(np.broadcast_to(_GROUND[1], (*shape, 3)), layers)
    # The ridges that bristles leave catch light from above.
    thick = picture.mean(axis=-1) - gaussian(picture.mean(axis=-1), 2.5 * max(unit, 0.7))
    slope = gaussian(thick, 0.5)
    relief = slope - np.pad(slope, ((1, 0), (1, 0)), mode="edge")[:-1, :-1]
    return picture + 1.1 * relief[..., None] + 0.25 * thick[..., None]


def _bristles(rng, lines, colours, width):
    """Each stroke as parallel hairs that differ in shade and length."""
    along = np.gradient(lines, axis=1)
    along /= np.linalg.norm(along, axis=-1, keepdims=True) + 1e-9
    across = along[..., ::-1] * (-1, 1)
    layers = []
    for hair in rng.permutation(_BRISTLES):
        offset = (hair / (_BRISTLES - 1) - 0.5) * width * rng.uniform(0.85, 1.15, len(lines))
        hairs = lines + across * offset[:, None, None]
        first = rng.integers(0, 3, len(lines))
        hairs[first > 0, 0] = hairs[first > 0, 1]
        shade = colours * (1 + rng.normal(0, 0.07, (len(lines), 1)))
        widths = width / _BRISTLES * rng.uniform(1.0, 1.9, len(lines))
        layers.append((hairs, shade, widths, 0.92))
    return layers
