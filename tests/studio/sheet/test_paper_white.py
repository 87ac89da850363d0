"""Light is known from the paper around the picture."""

import numpy as np
import pytest

from stylit_ref.studio.sheet.paper_white import evened, paper_places

PLACES = paper_places(1800, 1200, 40) / 60
GREY = np.full((20, 30, 3), 128, np.uint8)


def shown(light):
    return np.floor(255 * light ** (1 / 2.2) + 0.5).astype(np.uint8)


def lit(places):
    """Dimmer to the right and towards the corners, and yellow."""
    x, y = (2 * places / (30, 20) - 1).T
    fall = np.exp(-0.25 * x - 0.02 * x * x - 0.03 * y * y)
    return 0.55 * fall[:, None] * (1, 0.95, 0.7)


def pixels():
    y, x = np.mgrid[0.5:20, 0.5:30]
    return np.stack([x, y], axis=-1).reshape(-1, 2)


def test_places_lie_beside_the_picture_and_not_at_the_marks():
    x, y = paper_places(60, 40, 4).T
    inside_x, inside_y = (x > 0) & (x < 60), (y > 0) & (y < 40)
    assert (inside_x ^ inside_y).all()
    beside = np.where(inside_x, np.maximum(-y, y - 40), np.maximum(-x, x - 60))
    assert 20 < beside.min() < 30
    assert 160 < beside.max() < 180


@pytest.mark.parametrize("painted_over", [0.0, 0.3])
def test_what_is_lit_as_the_paper_becomes_even(painted_over):
    picture = shown(0.4 * lit(pixels())).reshape(20, 30, 3)
    paper = shown(lit(PLACES))
    rng = np.random.default_rng(0)
    paper[rng.random(len(paper)) < painted_over] = 60, 20, 90
    even = evened(picture, PLACES, paper)
    assert np.abs(even.astype(int) - int(shown(np.array(0.4)))).max() <= 4


def test_what_is_too_dark_for_paper_changes_nothing():
    picture = GREY.copy()
    picture[5:15] = 250
    table = np.full((len(PLACES), 3), 40, np.uint8)
    assert np.array_equal(evened(picture, PLACES, table), picture)
