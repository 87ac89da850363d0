"""The error budget on hand-made errors."""

import numpy as np
import pytest

from stylit_ref.stylization import error_budget
from stylit_ref.stylization.error_budget import (
    SHARE,
    correspondences_within_budget,
    fit_hyperbola,
    knee,
)

X = np.linspace(0, 1, 5001)


def hyperbola(a, b, scale=1e9):
    """Errors that lie on (a - bx)^-1."""
    return np.round(scale / (a - b * X)).astype(np.int64)


@pytest.mark.parametrize(("a", "b"), [(20.0, 19.0), (80.0, 79.0), (3.0, 2.0), (5.0, 4.9)])
def test_the_fit_finds_the_hyperbola_it_is_given(a, b):
    y = 1 / (a - b * X)
    middle = np.median(y)
    assert fit_hyperbola(X, y / middle) == pytest.approx((a * middle, b * middle), rel=1e-4)


@pytest.mark.parametrize(("a", "b"), [(20.0, 19.0), (80.0, 79.0), (30.0, 28.0)])
def test_the_slope_at_the_knee_is_1_where_the_curve_ends_at_1(a, b):
    f = 1 / (a - b * X)
    slope = np.gradient(f / f[-1], X)
    assert knee(a, b) == pytest.approx(np.interp(1, slope, X), abs=1e-3)


@pytest.mark.parametrize("scale", [1e6, 1e15])
def test_the_budget_ends_at_the_knee_in_every_unit(scale):
    within = correspondences_within_budget(hyperbola(20.0, 19.0, scale), "hyperbola")
    assert within == pytest.approx(5000 * knee(20.0, 19.0), abs=1)


@pytest.mark.parametrize("factor", [2, 10, 1000])
def test_the_largest_errors_alone_do_not_decide(factor):
    errors = hyperbola(20.0, 19.0)
    before = correspondences_within_budget(errors, "hyperbola")
    errors[-3:] *= factor
    assert correspondences_within_budget(errors, "hyperbola") == pytest.approx(before, rel=0.005)


def test_the_knee_lies_beyond_three_quarters():
    """Two good errors for three that are a thousand times as large."""
    errors = np.repeat([1, 1000], [400, 600])
    assert 750 <= correspondences_within_budget(errors, "hyperbola") <= 1000


def test_errors_that_rise_too_little_have_no_knee():
    flat = np.arange(1000, 1900)
    assert correspondences_within_budget(flat, "hyperbola") == 900
    assert knee(1.0, 0.4) == 1.0


@pytest.mark.parametrize("errors", [[0], [7], [0, 0, 0], [5] * 9])
def test_equal_errors_are_all_within(errors):
    assert correspondences_within_budget(np.array(errors), "hyperbola") == len(errors)


@pytest.mark.parametrize("errors", [[0, 1], [3, 2**50], [0, 0, 0, 9], [0] * 500 + [1] * 3])
def test_few_or_mostly_zero_errors_keep_at_least_one(errors):
    assert 1 <= correspondences_within_budget(np.array(errors), "hyperbola") <= len(errors)


def test_a_fit_that_fails_gives_way_to_a_share(monkeypatch):
    def fail(*_):
        raise RuntimeError

    errors = hyperbola(20.0, 19.0)
    by_share = correspondences_within_budget(errors, SHARE)
    assert by_share != correspondences_within_budget(errors, "hyperbola")
    monkeypatch.setattr(error_budget, "fit_hyperbola", fail)
    assert correspondences_within_budget(errors, "hyperbola") == by_share


@pytest.mark.parametrize(
    ("share", "within"), [(0.1, 1), (0.3, 2), (0.29, 1), (0.6, 3), (0.999, 3), (1.0, 4), (1e-9, 1)]
)
def test_a_share_of_the_sum_covers_the_smallest_errors(share, within):
    """Of 1 + 2 + 3 + 4 = 10: a sum of exactly T is within."""
    assert correspondences_within_budget(np.array([1, 2, 3, 4]), share) == within


def test_a_share_of_zeros_covers_them_all():
    assert correspondences_within_budget(np.zeros(5, np.int64), 0.5) == 5
