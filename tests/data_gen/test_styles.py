"""Painted styles: the same bytes again, and paint that answers the light."""

import numpy as np
import pytest

from data_gen.guides import to_uint8
from data_gen.styles import STYLES, subject

pytestmark = pytest.mark.slow

HEIGHT, WIDTH = 228, 300


@pytest.fixture(scope="module")
def layers():
    """A shaded sphere before a wall on a ground with a cast shadow, without a renderer."""
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    u, v = (x - 150) / 70, (y - 120) / 70
    inside = u**2 + v**2 < 1
    normal = np.stack([u, -v, np.sqrt(np.clip(1 - u**2 - v**2, 0, 1))], axis=-1) * inside[..., None]
    lit = np.clip(normal @ (0.35, 0.8, 0.48), 0, 1)
    shine = np.exp(-((u - 0.25) ** 2 + (v + 0.55) ** 2) / 0.01) * inside
    ground, wall = (y >= 150) & ~inside, (y < 150) & ~inside
    shadow = ground & (((x - 110) / 80) ** 2 + ((y - 190) / 22) ** 2 < 1)
    direct = np.where(inside, lit, np.where(wall, 0.4 + 0.6 * x / WIDTH, 0.9 * ~shadow))
    bounce = np.where(inside, 0.2 + 0.4 * np.clip(v, 0, 1), 0.3)

    def grey(values):
        return np.repeat(values[..., None], 3, axis=2).astype(np.float32)

    return {
        "LDE": grey(direct),
        "LSE": grey(shine),
        "LDDE": grey(bounce),
        "IDMASK": np.stack([inside, ground, wall], axis=-1).astype(np.float32),
        "NORMAL": normal.astype(np.float32),
    }


@pytest.fixture(scope="module", params=STYLES)
def painted(request, layers):
    return request.param, STYLES[request.param](subject(layers))


def test_the_same_seed_paints_the_same(painted, layers):
    name, picture = painted
    assert np.array_equal(to_uint8(STYLES[name](subject(layers))), to_uint8(picture))
    assert not np.array_equal(to_uint8(STYLES[name](subject(layers), seed=1)), to_uint8(picture))


def test_it_fills_the_picture(painted):
    _, picture = painted
    assert picture.shape == (HEIGHT, WIDTH, 3)
    assert np.isfinite(picture).all()
    assert to_uint8(picture).std() > 25


def test_light_is_painted_differently(painted):
    """The highlight is brighter than the lit side, that than the dark one; so on the ground."""
    _, picture = painted
    grey = picture.mean(axis=2)
    highlight, lit, dark = grey[78:86, 164:172], grey[70:100, 120:150], grey[150:175, 120:180]
    assert highlight.mean() > lit.mean() + 0.05 > dark.mean() + 0.1
    cast, floor = grey[185:197, 60:90], grey[185:197, 230:280]
    assert floor.mean() > cast.mean() + 0.1


def test_bounce_light_changes_the_paint(painted, layers):
    """Its mean colour below the sphere, and not elsewhere."""
    name, picture = painted
    dimmer = layers | {"LDDE": layers["LDDE"] * (layers["NORMAL"][..., 1:2] > -0.3)}
    other = STYLES[name](subject(dimmer))

    def shift(region):
        return np.abs(picture[region].mean(axis=(0, 1)) - other[region].mean(axis=(0, 1))).max()

    assert shift(np.s_[150:180, 120:180]) > 0.03
    assert shift(np.s_[20:100, 200:290]) < 0.02


def test_it_has_grain(painted):
    """Differences of neighbouring pixels where the subject itself is smooth."""
    _, picture = painted
    wall = picture[20:60, 20:120].mean(axis=2)
    assert np.abs(np.diff(wall, axis=1)).mean() > 0.008


def test_styles_differ(layers):
    seen = subject(layers)
    means = np.array([paint(seen).mean(axis=(0, 1)) for paint in STYLES.values()])
    distances = np.linalg.norm(means[:, None] - means, axis=2)
    assert distances[np.triu_indices(len(means), 1)].min() > 0.1
