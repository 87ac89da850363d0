"""Where a point appears, and what coherence costs, against exact arithmetic."""

from fractions import Fraction
from math import floor

import numpy as np
import pytest

from stylit_ref.views import passes
from stylit_ref.views.formulae.fold import ONE, fixed_weight
from stylit_ref.views.formulae.vectors import fixed, is_consistent


def folded(own, guides, weights):
    mixed = np.empty_like(own)
    spreads = np.empty((*own.shape[:2], 1), np.uint8)
    passes.fold(own, guides, np.array(weights, np.int64), mixed, spreads)
    return mixed, spreads


@pytest.mark.parametrize("weights", [[128], [256, 256], [128, 37, 1, 1024]])
def test_mean_and_spread_are_those_of_exact_arithmetic(weights):
    rng = np.random.default_rng(len(weights))
    own = rng.integers(0, 256, (9, 7, 3), dtype=np.uint8)
    guides = rng.integers(0, 256, (len(weights), 9, 7, 3), dtype=np.uint8)
    mixed, spreads = folded(own, guides, weights)

    everything = ONE + sum(weights)
    for y, x in np.ndindex(9, 7):
        variances = []
        for c in range(3):
            values = [(ONE, own[y, x, c]), *zip(weights, guides[:, y, x, c], strict=True)]
            mean = Fraction(sum(w * int(v) for w, v in values), everything)
            assert mixed[y, x, c] == floor(mean + Fraction(1, 2))
            mean_square = Fraction(sum(w * int(v) ** 2 for w, v in values), everything)
            variances.append(mean_square - mean**2)
        deviation = sum(variances)
        root = int(spreads[y, x, 0])
        assert max(Fraction(0), root - Fraction(1, 2)) ** 2 <= deviation
        assert deviation < (root + Fraction(1, 2)) ** 2


@pytest.mark.parametrize(("channels", "widest"), [(1, 128), (2, 180), (3, 221), (4, 255)])
@pytest.mark.parametrize("values", [(0, 255), (255, 0)])
def test_the_widest_spread_fits_8_bits(values, channels, widest):
    own = np.full((1, 1, channels), values[0], np.uint8)
    guides = np.full((1, 1, 1, channels), values[1], np.uint8)
    mixed, spreads = folded(own, guides, [ONE])
    assert (mixed == 128).all()
    assert (spreads == widest).all()


def test_neighbours_that_agree_change_nothing():
    own = np.arange(75, dtype=np.uint8).reshape(5, 5, 3)
    mixed, spreads = folded(own, np.stack([own, own]), [77, 500])
    assert np.array_equal(mixed, own)
    assert not spreads.any()


def test_weights_are_rounded_to_256ths():
    weights = (0, 1 / 1024, 1 / 512, 0.5, 1)
    assert [fixed_weight(weight) for weight in weights] == [0, 0, 1, 128, 256]


def test_a_place_is_shifted_by_its_motion_rounded_half_up():
    motion = np.zeros((1, 6, 2), np.float32)
    motion[0, :, 0] = [0.49, 0.5, -0.5, -0.51, 1.5, -9]
    places = np.empty((1, 6, 2), np.int32)
    passes.shift_map(motion, np.ones((1, 6), bool), 0, places)
    assert places[0, :, 1].tolist() == [0, 2, 2, 2, -1, -1]
    assert places[0, :, 0].tolist() == [0, 0, 0, 0, -1, -1]


def test_a_coarse_place_takes_the_motion_past_its_middle():
    motion = np.full((8, 8, 2), 100, np.float32)
    motion[2::4, 2::4] = [4, -4]
    places = np.empty((2, 2, 2), np.int32)
    passes.shift_map(motion, np.ones((8, 8), bool), 2, places)
    assert places.tolist() == [[[-1, -1], [-1, -1]], [[0, 1], [-1, -1]]]


@pytest.mark.parametrize("broken", [np.nan, np.inf, -np.inf, 1e30])
def test_motion_that_is_no_number_or_far_away_leads_nowhere(broken):
    motion = np.zeros((2, 2, 2), np.float32)
    motion[0, 1, 0] = broken
    places = np.empty((2, 2, 2), np.int32)
    passes.shift_map(motion, np.ones((2, 2), bool), 0, places)
    assert (places[0, 1] == -1).all()
    assert (places[1, 1] == 1).all()


def test_hidden_pixels_keep_their_own_colour():
    own = np.array([[[1], [2]]], np.uint8)
    picture = np.array([[[7], [8]]], np.uint8)
    places = np.array([[[0, 1], [-1, -1]]], np.int32)
    guide = np.empty_like(own)
    passes.shift_picture(picture, places, own, guide)
    assert guide[0, :, 0].tolist() == [8, 2]


@pytest.mark.parametrize("back", [1e30, np.inf, -np.inf])
def test_a_vector_that_leads_far_away_confirms_nothing(back):
    assert not is_consistent(fixed(1.0), fixed(-1.0), fixed(back), fixed(back))
    assert is_consistent(fixed(1.0), fixed(-1.0), fixed(-1.0), fixed(1.5))
