"""Differences are named; values within their tolerance do not differ."""

import numpy as np
import pytest

from oracle.cases import read_cases
from oracle.check import check
from oracle.compare import FAILED, PASSED
from oracle.families import NEWEST


@pytest.mark.parametrize(
    ("found", "said"),
    [
        ({}, "order is missing"),
        ({"order": np.zeros((16, 2), np.int64)}, "order is int64; it must be int32"),
        ({"order": np.zeros((2, 16), np.int32)}, "order has shape (2, 16); it must be (16, 2)"),
    ],
)
def test_what_differs_is_named(found, said):
    (outcome, _) = check(lambda case: found, NEWEST, ["commit_order"])
    assert outcome.status == FAILED
    assert said in outcome.difference.message


@pytest.mark.parametrize(
    ("off", "status"), [(0, PASSED), (0.5, PASSED), (2, FAILED), (np.nan, FAILED)]
)
def test_a_tolerance_is_relative(off, status):
    (case,) = read_cases(NEWEST, ["knee"])
    found = {"x": case.expected["x"] * (1 + off * case.tolerances["x"])}
    (outcome,) = check(lambda case: found, NEWEST, ["knee"])
    assert outcome.status == status
