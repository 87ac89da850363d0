"""The fast random search and the plain one find the same.

They share the formulae and δ; ``test_proposals.py`` checks the fast one independently.
"""

import numpy as np
import pytest
from small_level import make_level

from stylit_ref import passes
from stylit_ref.passes.plain_random_search import plain_random_search
from stylit_ref.randomness.random_stream import RANDOM_SEARCH, random_stream


@pytest.mark.parametrize("side", [None, 9])
@pytest.mark.parametrize(
    "case",
    [
        {},
        {"masked": np.eye(30, 33, dtype=bool), "uniformity": 100000},
        {"smooth": True, "epsilon": 520, "uniformity": 200},
        {"patch_width": 7, "epsilon": 1e12, "uniformity": 0, "flat_style": True},
    ],
    ids=str,
)
def test_both_find_the_same(case, side):
    level = make_level(target_size=(30, 33), **case)
    found = []
    for search in (passes.random_search, plain_random_search):
        new_nnf, new_delta = level.nnf.copy(), level.delta.copy()
        proposal = level.proposal._replace(new_nnf=new_nnf, new_delta=new_delta)
        search(*proposal, random_stream(2, RANDOM_SEARCH, 1), side)
        found.append((new_nnf, new_delta))
    for fast, plain in zip(*found, strict=True):
        np.testing.assert_array_equal(fast, plain)
    assert (found[0][0] != level.nnf).any()
