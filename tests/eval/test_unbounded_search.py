"""The search without the bound."""

import numpy as np
import pytest
from small_level import make_level

from eval.unbounded_search import UNBOUNDED
from stylit_ref import passes
from stylit_ref.randomness.random_stream import RANDOM_SEARCH, random_stream


@pytest.mark.parametrize(
    "case",
    [
        {},
        {"smooth": True, "epsilon": 520, "uniformity": 200},
        {"patch_width": 7, "epsilon": 1e12, "uniformity": 0, "flat_style": True},
    ],
    ids=str,
)
def test_the_search_without_the_bound_finds_the_same(case):
    level = make_level(target_size=(30, 33), **case)
    found = []
    for module in (passes, UNBOUNDED):
        new_nnf, new_delta = level.nnf.copy(), level.delta.copy()
        module.random_search(
            level.textures, level.omega_sums, level.occurrence_weight, level.patch_width,
            level.nnf, level.delta, new_nnf, new_delta, random_stream(2, RANDOM_SEARCH, 1),
        )  # fmt: skip
        found.append((new_nnf, new_delta))
    for bounded, unbounded in zip(*found, strict=True):
        np.testing.assert_array_equal(bounded, unbounded)
    assert (found[0][0] != level.nnf).any()
