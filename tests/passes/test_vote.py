import brute_force
import numpy as np
import pytest
from small_level import make_level


@pytest.mark.parametrize(
    "case",
    [
        {},
        {"patch_width": 3, "style_channels": 1},
        {"patch_width": 7, "style_channels": 4},
        {"masked": np.tri(14, 12, -6, dtype=bool)},
        {"source_size": (5, 5), "target_size": (1, 9)},
    ],
    ids=str,
)
def test_vote_is_the_mean_rounded_half_up(case):
    level = make_level(**case)
    level.vote()
    style = level.packing.style(level.textures.source)
    expected = brute_force.vote(style, level.nnf, level.patch_width)
    np.testing.assert_array_equal(level.style, expected)
    radius = level.patch_width // 2
    np.testing.assert_array_equal(
        level.packing.style(level.textures.target),
        brute_force.padded(level.style, radius),
        err_msg="the repeated edge follows the vote",
    )


@pytest.mark.parametrize("outliers", [1, 4, 24])
@pytest.mark.parametrize(
    "case",
    [
        {"crowded": True},
        {"style_channels": 1, "smooth": True},
        {"masked": np.tri(14, 12, dtype=bool)},
    ],
    ids=str,
)
def test_votes_far_from_the_mean_do_not_count(case, outliers):
    level = make_level(**case)
    level.vote_outliers = outliers
    level.vote()
    style = level.packing.style(level.textures.source)
    expected = brute_force.vote(style, level.nnf, level.patch_width, outliers)
    np.testing.assert_array_equal(level.style, expected)


def test_vote_brings_delta_up_to_date():
    level = make_level()
    level.vote()
    delta = level.delta.copy()
    level.update_similarity()
    np.testing.assert_array_equal(delta, level.delta)
