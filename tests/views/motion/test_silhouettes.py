"""Strokes beside silhouettes move with what they belong to."""

import numpy as np
import pytest
from views.motion.moving_square import SIZE, depth_of, labels_of, motion

from stylit_ref.views import passes
from stylit_ref.views.formulae.depth import inverse_depth
from stylit_ref.views.formulae.silhouette import STEP, reach_of
from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.silhouettes import along_silhouettes, silhouettes_of

OWN = np.stack(np.mgrid[: SIZE[0], : SIZE[1]], axis=-1)


@pytest.mark.parametrize(
    ("size", "reach"), [((48, 64), 1), ((228, 300), 4), ((300, 228), 4), ((456, 600), 8)]
)
def test_strokes_reach_farther_in_larger_pictures(size, reach):
    assert reach_of(*size) == reach


def steps_back(inverse, y, x):
    """Whether depth steps back beside a pixel, in words of lists."""
    height, width = inverse.shape

    def at(row, column, otherwise):
        inside = 0 <= row < height and 0 <= column < width
        return inverse[row, column] if inside else otherwise

    for down, right in ((-1, 0), (1, 0), (0, -1), (0, 1)):
        near, far = inverse[y, x], at(y + down, x + right, np.inf)
        before = at(y - down, x - right, near + (near - far))
        behind = at(y + 2 * down, x + 2 * right, far - (near - far))
        if near > STEP * far and near - far > 2 * min(abs(before - near), abs(far - behind)):
            return True
    return False


def test_rims_and_what_lies_beside_them_are_those_of_the_brute_force_twin():
    rng = np.random.default_rng(5)
    depth = np.repeat(np.repeat(rng.integers(1, 30, (5, 6)), 3, axis=0), 3, axis=1)
    inverse = inverse_depth(depth.astype(np.float32) + rng.normal(0, 0.1, depth.shape))
    size, reach = inverse.shape, 2
    rims, places = np.empty(size, bool), np.empty((*size, 2), np.int32)
    passes.find_rims(inverse, rims)
    passes.take_nearer(inverse, rims, np.ones(size, bool), reach, places)
    for y, x in np.ndindex(size):
        assert rims[y, x] == steps_back(inverse, y, x)
        near = [
            ((row - y) ** 2 + (column - x) ** 2, -inverse[row, column], row, column)
            for row, column in np.argwhere(rims)
            if inverse[row, column] > STEP * inverse[y, x]
        ]
        near = [each for each in near if each[0] <= reach**2]
        expected = (y, x)
        if near:
            rim = expected = min(near)[2:]
            past = tuple(int(r + np.sign(r - p)) for r, p in zip(rim, (y, x), strict=True))
            inside = 0 <= past[0] < size[0] and 0 <= past[1] < size[1]
            if inside and inverse[rim] <= STEP * inverse[past]:
                expected = past
        assert tuple(places[y, x]) == expected
    assert (places != np.stack(np.mgrid[: size[0], : size[1]], axis=-1)).any()


def test_a_plane_that_recedes_has_no_rims():
    """Its depth more than doubles from row to row at the horizon."""
    inverse = np.repeat(np.arange(1, 21, dtype=float)[:, None] / 100, 8, axis=1)
    rims = np.empty(inverse.shape, bool)
    passes.find_rims(inverse, rims)
    assert not rims.any()


@pytest.mark.parametrize("nothing", [0, -1, np.inf, -np.inf, np.nan, 1e9])
def test_nothing_is_infinitely_far_away(nothing):
    assert inverse_depth(np.float32([[nothing, 4]])).tolist() == [[0, 0.25]]


def test_ground_beside_the_square_moves_with_it():
    found = silhouettes_of(depth_of(0))
    on_square = labels_of(0) == 2
    assert not found.beside[on_square].any()
    for y, x in np.ndindex(SIZE):  # the reach is 1
        cross = (slice(max(y - 1, 0), y + 2), x), (y, slice(max(x - 1, 0), x + 2))
        around = any(on_square[line].any() for line in cross)
        assert found.beside[y, x] == (around and not on_square[y, x])
    moved = along_silhouettes(motion(0, 1), found, silhouettes_of(depth_of(1)))
    assert (moved.field[found.beside] == motion(0, 1).field[on_square][0]).all()
    assert moved.visible[found.beside].all()
    away = ~found.beside
    assert np.array_equal(moved.field[away], motion(0, 1).field[away])


def test_what_becomes_a_stroke_of_the_square_is_hidden():
    """Ground that the other frame shows beside the square, where its outline is."""
    before, there = motion(0, 1), silhouettes_of(depth_of(1))
    moved = along_silhouettes(before, silhouettes_of(depth_of(0)), there)
    hidden = before.visible & ~moved.visible
    leads_to = OWN + before.field[:, :, ::-1].astype(int)
    assert hidden.any()
    assert all(there.beside[tuple(leads_to[y, x])] for y, x in np.argwhere(hidden))


def test_ids_alone_tell_what_lies_before_nothing():
    labels = labels_of(0)
    assert not silhouettes_of(None, labels).beside.any()
    alone = silhouettes_of(None, np.where(labels == 2, labels, 0))
    assert np.array_equal(alone.beside, silhouettes_of(depth_of(0)).beside)


def test_without_depth_and_ids_nothing_is_known():
    assert silhouettes_of(None) is None


def test_a_frame_without_silhouettes_keeps_its_motion():
    before = Motion(motion(0, 1).field, np.random.default_rng(0).random(SIZE) < 0.9)
    flat = silhouettes_of(np.full(SIZE, 3, np.float32))
    after = along_silhouettes(before, flat, flat)
    inside = before.visible & motion(0, 1).visible
    assert np.array_equal(after.field, before.field)
    assert np.array_equal(after.visible, before.visible)
    assert inside.any()


def test_a_camera_that_comes_closer_hides_nothing_but_beside_silhouettes():
    here, there = silhouettes_of(depth_of(0)), silhouettes_of(depth_of(0) / 2)
    still = Motion(np.zeros((*SIZE, 2), np.float32), np.ones(SIZE, bool))
    assert np.array_equal(along_silhouettes(still, here, there).visible, ~here.beside)
