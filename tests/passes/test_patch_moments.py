import numpy as np
import pytest
from small_level import make_level

from stylit_ref.metric.lower_bound import POLYNOMIALS, moment_width, patch_moment


def expected_moments(texture, packing, patch_width, first_y, first_x):
    """By the plain formula, for the patch whose first pixel is given."""
    width = moment_width(patch_width)
    margin = patch_width // 2 - width // 2
    return [
        (moment
        and patch_moment(
            texture, first_y + margin, first_x + margin, moment[0],
            POLYNOMIALS[width][moment[1][0]], POLYNOMIALS[width][moment[1][1]],
        ))
        or 0
        for moment in packing.moments
    ]  # fmt: skip


@pytest.mark.parametrize(
    "case",
    [
        {"patch_width": 3, "guide_channels": (1,), "style_channels": 1},
        {"patch_width": 5},
        {"patch_width": 5, "guide_channels": (5, 9), "style_channels": 4},
        {"patch_width": 13, "style_channels": 2},
    ],
    ids=str,
)
def test_moments_are_the_formula(case):
    level = make_level(source_size=(16, 15), target_size=(14, 3), **case)
    radius = level.patch_width // 2
    textures = level.textures
    for y in range(16 - 2 * radius):
        for x in range(15 - 2 * radius):
            np.testing.assert_array_equal(
                textures.source_moments[radius + y, radius + x],
                expected_moments(textures.source, level.packing, level.patch_width, y, x),
            )
    for y, x in np.ndindex(14, 3):
        np.testing.assert_array_equal(
            textures.target_moments[y, x],
            expected_moments(textures.target, level.packing, level.patch_width, y, x),
        )


def test_moments_follow_a_vote():
    level = make_level()
    level.vote()
    before = level.textures.target_moments.copy()
    level.update_moments()
    updated = level.textures.target_moments.copy()
    assert (updated != before).any()
    level.textures.target_moments[:] = 0
    level.passes.patch_moments(
        level.textures.target, level.textures.target_moments, 5, 0,
        level.packing.style_channel, level.packing.style_channels,
    )  # fmt: skip
    np.testing.assert_array_equal(updated, level.textures.target_moments)


@pytest.mark.parametrize(("guide_channels", "line_bytes"), [((3, 3), 64), ((3,) * 5, 128)])
def test_moments_fill_cache_lines(guide_channels, line_bytes):
    level = make_level(guide_channels=guide_channels)
    for moments in (level.textures.source_moments, level.textures.target_moments):
        assert moments.ctypes.data % 64 == 0
        assert moments.strides[1] == line_bytes
