"""Means and guide maps against their definitions (thesis 5.2)."""

from fractions import Fraction
from math import nextafter

import brute_force
import numpy as np
import pytest
from small_level import make_level

from stylit_ref import passes
from stylit_ref.formulae.guide_map import delta_by_means, variance_limit

CASES = [
    {"smooth": True},
    {"patch_width": 3, "guide_channels": (1,)},
    {"smooth": True, "patch_width": 7, "guide_channels": (1, 4), "guide_weights": (0.0, 2.0)},
    {"patch_width": 17, "source_size": (18, 19), "target_size": (5, 6)},
]


def guides(level, patch, counted=False):
    """The guides' channels of a patch, all or those that count."""
    patch = patch[:, :, : level.packing.style_channel]
    return patch[:, :, level.packing.weights[: patch.shape[2]] > 0] if counted else patch


def target_patch(level, y, x):
    width = level.patch_width
    return level.textures.target[y : y + width, x : x + width]


@pytest.mark.parametrize("case", CASES, ids=str)
def test_sums_are_means_times_the_pixels_of_a_patch(case):
    level = make_level(epsilon=100, **case)
    width, radius = level.patch_width, level.patch_width // 2
    for y, x in np.ndindex(*level.delta.shape):
        means = brute_force.mean(guides(level, target_patch(level, y, x)))
        assert level.textures.target_sums[y, x].tolist() == [width**2 * mean for mean in means]
    rows, columns = level.omega.shape
    for y, x in np.ndindex(rows - 2 * radius, columns - 2 * radius):
        patch = level.textures.source[y : y + width, x : x + width]
        means = brute_force.mean(guides(level, patch))
        assert level.textures.source_sums[radius + y, radius + x].tolist() == [
            width**2 * mean for mean in means
        ]


def test_sums_of_white_images_do_not_overflow():
    for patch_width in (15, 17):
        level = make_level(epsilon=1, patch_width=patch_width, source_size=(19, 19))
        level.textures.target[:] = 255
        passes.means(level.textures.target, level.textures.target_sums, patch_width, 0)
        assert (level.textures.target_sums == 255 * patch_width**2).all()


@pytest.mark.parametrize("case", CASES, ids=str)
def test_the_map_is_white_where_the_variance_is_below_epsilon(case):
    """Below, not at: ε is taken from the variances themselves, and just above one of them."""
    plain = make_level(**case)
    variances = {
        place: brute_force.variance(guides(plain, target_patch(plain, *place), counted=True))
        for place in np.ndindex(*plain.delta.shape)
    }
    middle = sorted(variances.values())[len(variances) // 2]
    whites = []
    for epsilon in (0.0, float(middle), nextafter(float(middle), 1e9), 1e12):
        level = make_level(epsilon=epsilon, **case)
        for place, variance in variances.items():
            assert level.textures.guide_map[place] == (variance < Fraction(epsilon))
        whites.append(level.textures.guide_map.mean())
    assert whites[0] == 0
    assert whites[-1] == 1
    assert 0 < whites[2] < 1 or len(variances) == 30


@pytest.mark.parametrize("case", CASES, ids=str)
def test_delta_of_white_patches_compares_means(case):
    level = make_level(epsilon=1e12, **case)
    for y, x in np.ndindex(*level.delta.shape):
        place = (y, x, *map(int, level.nnf[y, x]))
        assert level.delta[y, x] == brute_force.guide_map_delta(
            level.textures.source, level.textures.target, brute_force.weights_of(level.packing),
            level.patch_width, level.packing.style_channel, *place,
        )  # fmt: skip


@pytest.mark.parametrize("case", CASES, ids=str)
def test_the_plainest_form_is_the_fast_one(case):
    level = make_level(epsilon=1e12, **case)
    textures = level.textures
    for y, x in np.ndindex(*level.delta.shape):
        source_y, source_x = map(int, level.nnf[y, x])
        assert level.delta[y, x] == delta_by_means(
            textures.source, textures.target, textures.weights, textures.target_sums,
            textures.source_sums, level.patch_width, y, x, source_y, source_x,
        )  # fmt: skip


@pytest.mark.parametrize("epsilon", [np.float32(100), np.int64(100), 100])
def test_epsilon_may_be_any_number(epsilon):
    assert variance_limit(epsilon, np.int64(5)) == 100 * 5**4
    assert variance_limit(np.int64(10**11), 63) == 10**11 * 63**4


def test_without_white_patches_the_metric_is_the_plain_one():
    plain, mapped = make_level(smooth=True), make_level(smooth=True, epsilon=0)
    np.testing.assert_array_equal(plain.delta, mapped.delta)
