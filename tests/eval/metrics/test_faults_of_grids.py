"""Faults of pictures from a sparse grid: each provoked, and absent, by construction."""

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

from eval.metrics.grid_contrast import grid_contrast
from eval.metrics.ground_seams import flat_ground, misfits
from eval.metrics.ragged import raggedness
from eval.metrics.stroke_ends import ends_by_length
from eval.metrics.wrong_things import BACKGROUND, FOREGROUND

SIDE = 120
Y, X = np.mgrid[:SIDE, :SIDE]


def paint(seed, width=0.0):
    """Grey noise, blurred."""
    noise = gaussian_filter(np.random.default_rng(seed).normal(size=(SIDE, SIDE)), width)
    grey = np.uint8(np.clip(128 + 50 * noise / noise.std(), 0, 255))
    return np.repeat(grey[..., None], 3, axis=2)


def blended(step):
    """Noise that is the mean of two patches to the right of every ``step``-th column."""
    one, other = paint(0).astype(int), paint(1).astype(int)
    return np.where((X % step == 0)[..., None], one, (one + other) // 2).astype(np.uint8)


def pieces(side):
    """An NNF of square pieces from anywhere."""
    corners = np.random.default_rng(3).integers(0, SIDE - side, (SIDE, SIDE, 2))
    corners = corners[Y // side * side, X // side * side]
    return (corners + np.stack([Y % side, X % side], axis=-1)).astype(np.int32)


@pytest.mark.parametrize("step", [2, 3, 4])
def test_detail_that_comes_and_goes_with_a_grid(step):
    assert grid_contrast(blended(step)) > 0.15
    turned = grid_contrast(np.swapaxes(blended(step), 0, 1))
    assert turned == pytest.approx(grid_contrast(blended(step)))


def test_detail_that_knows_no_grid():
    assert grid_contrast(paint(0)) < 0.05
    assert grid_contrast(np.full((9, 9, 3), 7, np.uint8)) == 0


def test_pieces_that_do_not_continue_each_other_have_seams():
    """The smaller the pieces, the more of them; a copy has none."""
    style = paint(2, 3.0)
    inside = np.zeros((SIDE, SIDE), np.bool_)
    inside[2:-2, 2:-2] = True
    copy = np.stack([Y, X], axis=-1).astype(np.int32)
    assert not misfits(style, style, copy, inside).any()
    large, small = (
        np.sqrt(misfits(style[nnf[..., 0], nnf[..., 1]], style, nnf, inside).mean())
        for nnf in (pieces(40), pieces(10))
    )
    assert 10 < large < small


def test_flat_ground_is_background_away_from_all_else():
    labels = np.full((60, 60), BACKGROUND)
    labels[:, 40:] = FOREGROUND
    ground = flat_ground(labels)
    assert ground[30, 20]
    assert not ground[30, 30]


def test_an_edge_that_strays_from_its_course():
    mask = X < SIDE // 2
    ragged = SIDE // 2 + np.where(Y // 3 % 2, 2, -2) > X
    straight, strayed = (
        raggedness(np.repeat(np.uint8(200 * edge)[..., None], 3, axis=2), mask)
        for edge in (mask, ragged)
    )
    assert straight < 0.05
    assert 1 < strayed < 2


def test_an_edge_that_is_not_painted():
    assert raggedness(np.full((SIDE, SIDE, 3), 90, np.uint8), X < SIDE // 2) is None


def test_pieces_of_strokes_have_more_ends():
    """Strokes of 88 pixels, whole and in pieces of 18."""
    whole = (Y % 8 == 4) & (X >= 10) & (X < 98)
    cut = whole & ((X - 10) % 22 < 18)
    assert ends_by_length(whole) == pytest.approx(2 / 88)
    assert ends_by_length(cut) == pytest.approx(2 / 18)
    assert ends_by_length(np.zeros((9, 9), np.bool_)) is None
