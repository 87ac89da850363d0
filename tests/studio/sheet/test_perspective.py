"""Homographies, and pictures drawn through them."""

import numpy as np
import pytest
from PIL import Image

from stylit_ref.studio.sheet.perspective import drawn_through, homography, least_turn, through

SQUARE = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float)
OUTLINE = np.array([(310, 120), (1420, 200), (1350, 1180), (250, 1010)], float)


def test_corners_go_to_corners():
    assert np.allclose(through(homography(SQUARE, OUTLINE), SQUARE), OUTLINE)


def test_more_points_agree_on_one():
    matrix = homography(SQUARE, OUTLINE)
    points = np.random.default_rng(0).uniform(-1, 2, (30, 2))
    assert np.allclose(homography(points, through(matrix, points)), matrix)


@pytest.mark.parametrize(
    ("order", "turn"),
    [([0, 1, 2, 3], 1), ([0, 3, 2, 1], -1), ([0, 2, 1, 3], -1), ([0, 1, 2, 2], 0)],
    ids=["clockwise", "mirrored", "crossed", "triangle"],
)
def test_only_corners_that_go_around_turn_the_same_way(order, turn):
    assert least_turn(SQUARE[order]) == turn


@pytest.mark.parametrize("shrink", [1, 2, 3, 7])
def test_a_smaller_picture_has_the_mean_of_what_a_pixel_covers(shrink):
    fine = np.random.default_rng(0).integers(0, 256, (42, 84, 3), np.uint8)
    drawn = drawn_through(
        Image.fromarray(fine), np.diag([shrink, shrink, 1.0]), (84 // shrink, 42 // shrink)
    )
    means = fine.reshape(42 // shrink, shrink, 84 // shrink, shrink, 3).mean(axis=(1, 3))
    assert np.abs(drawn - means).max() <= 1


def test_a_gradient_stays_where_it_is():
    """Without a shift of half a pixel, at any size."""
    x = np.arange(200) + 0.5
    image = Image.fromarray(np.repeat(np.tile(x, (200, 1))[..., None], 3, axis=2).astype(np.uint8))
    for size in (20, 50, 100):
        drawn = drawn_through(image, np.diag([200 / size, 200 / size, 1]), (size, size))
        expected = (np.arange(size) + 0.5) * 200 / size
        assert np.abs(drawn[size // 2, 2:-2, 0] - expected[2:-2]).max() < 1.2
