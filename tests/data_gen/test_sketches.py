"""Architectural sketches: what each of them does against its guides."""

import numpy as np
import pytest

from data_gen.guides import to_uint8
from data_gen.sketches import SKETCHES, building
from data_gen.sketches.strokes import hatching, ruled
from data_gen.sketches.two_walls import _planes_in_turn

HEIGHT, WIDTH = 114, 150
LEFT, RIGHT = np.s_[40:85, 40:65], np.s_[40:85, 75:100]
"""Two walls that face the same way, the right one nearer; both in the light."""


@pytest.fixture(scope="module")
def layers():
    """Two grey walls on a green ground, whose left part is in shadow, under a black sky."""
    ids = np.zeros((HEIGHT, WIDTH, 3))
    normal, position = np.zeros_like(ids), np.zeros_like(ids)
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    ids[30:] = (0, 1, 0)
    normal[30:] = (0, 1, 0)
    walls = np.zeros((HEIGHT, WIDTH), bool)
    walls[35:90, 35:105] = True
    ids[walls], normal[walls] = (1, 0, 0), (0, 0, 1)
    position[..., 0], position[..., 1] = x / 10, np.where(walls, (90 - y) / 10, 0)
    position[..., 2] = np.where(walls, np.where(x < 70, 2.0, 3.4), 5.0)
    shadow = (y > 40) & (x < 30) | (walls & (y < 39))
    full = np.where(walls[..., None], 0.5, ids * 0.3)
    lit = (ids.max(axis=-1) > 0) & ~shadow
    mask = np.stack([np.zeros_like(lit), lit, shadow & (ids.max(axis=-1) > 0)], axis=-1)
    layers = {
        "FULL": full,
        "IDMASK": ids,
        "LIGHTMASK": mask,
        "NORMAL": normal,
        "POSITION": position,
    }
    return {name: layer.astype(np.float32) for name, layer in layers.items()}


@pytest.fixture(scope="module")
def seen(layers):
    corners = np.array([(35, 35), (105, 35), (105, 90), (35, 90)], float)
    lines = [*np.stack([corners, np.roll(corners, -1, axis=0)], axis=1), [(70, 35), (70, 90)]]
    return building(layers, np.array(lines))


@pytest.fixture(scope="module")
def drawn(seen):
    return {name: draw(seen) for name, draw in SKETCHES.items()}


@pytest.mark.parametrize("name", SKETCHES)
def test_the_same_seed_draws_the_same(name, seen, drawn):
    assert drawn[name].shape == (HEIGHT, WIDTH, 3)
    assert np.array_equal(to_uint8(SKETCHES[name](seen)), to_uint8(drawn[name]))
    assert not np.array_equal(to_uint8(SKETCHES[name](seen, seed=1)), to_uint8(drawn[name]))


@pytest.mark.parametrize("name", SKETCHES)
def test_the_sky_stays_blank(name, drawn):
    sky = drawn[name][:6]
    assert sky.min() > 0.9
    assert sky.std(axis=(0, 1)).max() < 0.03


def test_the_parts_of_a_building_are_told_apart(seen):
    assert seen.body.sum() == 55 * 70
    assert seen.ground.sum() == 84 * WIDTH - 55 * 70
    assert seen.is_outline.tolist() == [True, True, True, True, False]
    assert (seen.part[:30] == -1).all()


def test_ink_leaves_the_geometry(seen, drawn):
    """Dark pixels of the lit ground, more than three pixels from every edge."""
    beside = np.zeros((HEIGHT, WIDTH), bool)
    beside[22:103, 34:118] = True
    beside[31:94, 31:109] = False
    dark = drawn["inked"].mean(axis=-1) < 0.6
    assert dark[beside].sum() > 20
    assert (drawn["unshadowed"].mean(axis=-1) < 0.6)[beside].sum() < 10


def test_washes_are_less_steep_than_ink(drawn):
    """Steps between neighbouring pixels of brightness; lines are the steepest."""

    def steep(name):
        return np.percentile(np.abs(np.diff(drawn[name].mean(axis=-1), axis=1)), 99)

    assert steep("washed") < 0.7 * steep("inked")


def test_hatching_fills_an_even_shadow(drawn):
    shadow = drawn["hatched"][45:110, 2:28].mean(axis=-1)
    assert 0.2 < (shadow < 0.7).mean() < 0.8
    assert (drawn["hatched"][95:110, 110:145] > 0.9).all()


def test_marker_strokes_run_over_the_neighbours(layers, drawn):
    """Grey of the walls lies on green ground."""
    beside = drawn["marker"][50:85, 106:109]
    far = drawn["marker"][50:85, 135:145]
    greenness = [(p[..., 1] - p[..., 0]).mean() for p in (beside, far)]
    assert greenness[0] < 0.8 * greenness[1]


def test_walls_with_equal_guides_are_drawn_differently(layers, seen, drawn):
    for name in ("FULL", "IDMASK", "LIGHTMASK", "NORMAL"):
        assert np.array_equal(layers[name][LEFT], layers[name][RIGHT])
    bricks, boards = _planes_in_turn(seen)
    assert bricks[LEFT].all()
    assert boards[RIGHT].all()
    difference = drawn["two_walls"][LEFT].mean(axis=(0, 1)) - drawn["two_walls"][RIGHT].mean(
        axis=(0, 1)
    )
    assert np.abs(difference).max() > 0.15


def test_no_shadow_is_cast_on_the_ground(drawn):
    assert (drawn["unshadowed"][45:110, 2:28] > 0.9).all()
    assert drawn["two_walls"][60:100, 5:25].mean() < 0.85


def test_ruled_lines_pass_their_ends():
    line = np.array([[(20.0, 50.0), (120.0, 50.0)]])
    drawn = ruled(np.random.default_rng(0), np.repeat(line, 50, axis=0), 1.0, overshoot=10, drift=1)
    assert (drawn[:, 0, 0] < 20).all()
    assert (drawn[:, -1, 0] > 120).all()
    assert 0.5 < drawn[..., 1].std() < 2


def test_hatching_stays_inside():
    inside = np.zeros((60, 80), bool)
    inside[20:40, 10:50] = True
    ends = hatching(np.random.default_rng(0), inside, 0.6, 6.0, 1.0).reshape(-1, 2)
    assert len(ends) > 40
    assert inside[np.round(ends[:, 1]).astype(int), np.round(ends[:, 0]).astype(int)].all()
