"""Weights of views, and the mean they give."""

import pytest

from stylit_ref.views.interpolation.formulae.mean import mean_of_votes, reciprocal_of
from stylit_ref.views.interpolation.formulae.weights import (
    ONE,
    fading_weight,
    linear_weight,
    weighted_mean,
)


def test_a_linear_weight_is_the_share_of_the_way():
    assert [linear_weight(at, 20.0, 25.0) for at in (20.0, 21.25, 22.5, 25.0)] == [0, 64, 128, ONE]
    assert linear_weight(20 + 5 * 0.5 / ONE, 20.0, 25.0) == 1  # rounded half up


def test_one_view_alone_has_the_whole_weight():
    assert linear_weight(3.0, 3.0, 3.0) == 0
    assert fading_weight(3.0, 3.0, 3.0, 0.6) == 0


def test_a_fade_is_flat_beside_its_band():
    fades = [fading_weight(at, 0.0, 5.0, 0.6) for at in (0.0, 1.0, 2.5, 4.0, 5.0)]
    assert fades == [0, 0, 128, ONE, ONE]
    assert fading_weight(1.75, 0.0, 5.0, 0.6) == 64


def test_without_a_band_the_first_counts_up_to_the_middle():
    assert [fading_weight(at, 0.0, 5.0, 0.0) for at in (2.4, 2.5, 2.6)] == [0, 0, ONE]


def test_a_fade_over_the_whole_way_is_linear():
    for k in range(51):
        at = k / 10
        assert fading_weight(at, 0.0, 5.0, 1.0) == pytest.approx(linear_weight(at, 0, 5), abs=1)


def test_a_weighted_mean_is_rounded_half_up():
    assert [weighted_mean(total, 4) for total in (1, 2, 5, 6)] == [0, 1, 1, 2]


@pytest.mark.parametrize("count", [1, 2, 3, 9, 15, 25, 45, 225])
def test_the_mean_of_votes_needs_no_division(count):
    reciprocal = reciprocal_of(count)
    totals = {0, 1, *(k * count + d for k in range(255) for d in (count // 2, (count + 1) // 2))}
    for total in totals | {total - 1 for total in totals if total} | {255 * count}:
        mean = mean_of_votes.py_func(total, count, reciprocal)
        assert mean == (2 * total + count) // (2 * count)
