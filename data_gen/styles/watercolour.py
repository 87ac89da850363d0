"""Watercolour: transparent washes that darken at their edges and bleed into each other."""

import numpy as np
from scipy.ndimage import map_coordinates
from skimage.filters import gaussian

from data_gen.styles.painting import noise, paper_grain

_PAPER = np.array((0.98, 0.97, 0.94))
# What a full wash lets through, per pigment.
_SCARLET = np.array((0.93, 0.46, 0.34))
_CRIMSON = np.array((0.72, 0.22, 0.36))
_VIOLET = np.array((0.42, 0.30, 0.58))
_ULTRAMARINE = np.array((0.40, 0.50, 0.78))
_OCHRE = np.array((0.95, 0.84, 0.58))
_SAP = np.array((0.72, 0.82, 0.60))


def watercolour(subject, seed=23):
    """Paint a :class:`Subject`; (H, W, 3) float."""
    rng = np.random.default_rng(seed)
    shape, unit = subject.light.shape, subject.unit
    light, bounce = subject.light, subject.bounce
    white = subject.shine > 0.2
    dark = subject.object * (1 - light)
    grain = paper_grain(rng, shape)
    washes = (  # where, pigment, strength, wet: share of its edge that bleeds
        (subject.wall * (0.35 + 0.65 * (1 - light) > 0.38), _ULTRAMARINE, 0.55, 0.6),
        (subject.wall * (noise(rng, shape, 220 * unit) > 0.3), _SAP, 0.5, 0.9),
        (subject.ground * (noise(rng, shape, 260 * unit) > -0.4), _OCHRE, 0.6, 0.8),
        (subject.ground * (light < 0.55), _ULTRAMARINE, 0.75, 0.5),
        (subject.ground * (light < 0.22), _VIOLET, 0.8, 0.3),
        (subject.object * ~white, _SCARLET, 0.9, 0.1),
        (subject.object * (light < 0.72) * ~white, _SCARLET, 0.6, 0.5),
        (subject.object * (light < 0.38), _CRIMSON, 0.7, 0.6),
        ((dark > 0.85) * (bounce < 0.55), _VIOLET, 0.8, 0.7),
    )
    density = np.zeros((*shape, 3))
    for where, pigment, strength, wet in washes:
        wash = _wash(rng, np.asarray(where, float), unit, wet)
        granules = 1 + 0.55 * (grain - 0.5) + 0.16 * noise(rng, shape, 40 * unit)
        density -= (strength * wash * granules)[..., None] * np.log(pigment)
    picture = _PAPER * np.exp(-np.maximum(density, 0))
    return picture * (1 + 0.05 * (grain - 0.5))[..., None]


def _wash(rng, where, unit, wet):
    """Density of one wash: a wandering outline, a dark rim, soft where the paper was wet."""
    shape = where.shape
    rows, columns = np.mgrid[: shape[0], : shape[1]].astype(float)
    for size, shift in ((90, 6.0), (18, 1.6)):
        rows += shift * unit * noise(rng, shape, size * unit)
        columns += shift * unit * noise(rng, shape, size * unit)
    wandering = map_coordinates(where, [rows, columns], order=1, mode="nearest")
    dry = gaussian(wandering, 0.9 * max(unit, 0.6))
    rim = np.clip(dry - gaussian(wandering, 7 * unit), 0, 1)
    bled = gaussian(wandering, 16 * unit)
    feathered = np.clip(
        bled + 0.25 * (bled > 0.05) * (bled < 0.95) * noise(rng, shape, 9 * unit), 0, 1
    )
    soft = 1 / (1 + np.exp(-4 * (noise(rng, shape, 130 * unit) + 2.4 * wet - 1.4)))
    return soft * feathered + (1 - soft) * (dry * 0.86 + 1.5 * rim)
