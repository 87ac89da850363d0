"""Votes of a style at its own depth, beside the twin of the votes of a run."""

import brute_force
import numpy as np
import pytest
from small_level import make_level

from stylit_ref.passes import replay_vote

CASES = [
    {},
    {"crowded": True, "style_channels": 1},
    {"patch_width": 7, "style_channels": 4, "smooth": True},
    {"masked": np.tri(14, 12, dtype=bool)},
]


@pytest.mark.parametrize("outliers", [0, 1, 4, 24])
@pytest.mark.parametrize("case", CASES, ids=str)
def test_means_are_those_of_the_run(case, outliers):
    level = make_level(**case)
    style = np.ascontiguousarray(level.packing.style(level.textures.source))
    means = np.zeros((*level.nnf.shape[:2], style.shape[2]))
    replay_vote(style, means, level.nnf, level.patch_width, 1, outliers)
    expected = brute_force.vote(style, level.nnf, level.patch_width, outliers)
    np.testing.assert_array_equal(np.floor(means + 0.5), expected)


@pytest.mark.parametrize("outliers", [0, 4])
def test_depth_and_size_do_not_change_which_votes_count(outliers):
    level = make_level(crowded=True)
    style = np.ascontiguousarray(level.packing.style(level.textures.source))
    height, width, channels = *level.nnf.shape[:2], style.shape[2]
    means, deep = np.zeros((height, width, channels)), np.zeros((2 * height, 2 * width, channels))
    replay_vote(style, means, level.nnf, level.patch_width, 1, outliers)
    large = (style.astype(np.uint16) * 257).repeat(2, axis=0).repeat(2, axis=1)
    replay_vote(large, deep, level.nnf, level.patch_width, 2, outliers)
    np.testing.assert_allclose(deep, 257 * means.repeat(2, axis=0).repeat(2, axis=1), rtol=1e-12)
