"""The lower bound of δ that moments give."""

import brute_force
import numpy as np
import pytest
from numba import njit
from small_level import make_level

from stylit_ref.machine.vector_ssd import make_weighted_ssd
from stylit_ref.metric.fast_metric import make_fast_metric
from stylit_ref.metric.lower_bound import BOUND_SCALE, POLYNOMIALS, STYLE_DEGREES, squared_norm
from stylit_ref.metric.textures import vector_sizes


@pytest.mark.parametrize("width", [3, 5])
def test_polynomials_are_orthogonal(width):
    products = np.array(POLYNOMIALS[width]) @ np.array(POLYNOMIALS[width]).T
    assert np.count_nonzero(products - np.diag(np.diag(products))) == 0


@pytest.mark.parametrize("width", [3, 5])
def test_moments_that_share_a_weight_have_equal_norms(width):
    for degrees in STYLE_DEGREES:
        assert len({squared_norm(width, degree) for degree in degrees}) == 1


def fast_bound(level, y, x, source_y, source_x):
    moments_ssd = make_weighted_ssd(1, 1, len(level.packing.moments), element_bits=16)

    @njit
    def call(a, b, weights):
        return moments_ssd(a, 0, 0, b, 0, 0, weights)

    return call(
        level.textures.target_moments[y, x].copy(),
        level.textures.source_moments[source_y, source_x].copy(),
        level.textures.moment_weights,
    )


@pytest.mark.parametrize("patch_width", [3, 5, 7])
@pytest.mark.parametrize("pattern", ["noise", "ramp", "saddle", "flat"])
def test_it_is_a_bound_and_tight_for_what_it_describes(patch_width, pattern):
    level = make_level(patch_width=patch_width, source_size=(9, 9), target_size=(9, 9))
    y, x = np.mgrid[-4:5, -4:5]
    shape = {"ramp": 20 * x + 30 * y, "saddle": 7 * x * y + 4 * x * x, "flat": 0 * x + 90}
    style = level.packing.style(level.textures.source)
    if pattern in shape:
        style[:] = np.clip(shape[pattern] + 128, 0, 255)[:, :, None]
        level.packing.style(level.textures.target)[:] = 128
        for channel in level.packing.guide_channels:
            level.textures.source[:, :, channel : channel + 3] = 7
            level.textures.target[:, :, channel : channel + 3] = 9
    level.passes.patch_moments(
        level.textures.source, level.textures.source_moments, patch_width, patch_width // 2,
        level.packing.style_channel, level.packing.style_channels,
    )  # fmt: skip
    level.passes.patch_moments(
        level.textures.target, level.textures.target_moments, patch_width, 0,
        level.packing.style_channel, level.packing.style_channels,
    )  # fmt: skip
    delta = brute_force.delta(
        level.textures.source, level.textures.target, brute_force.weights_of(level.packing),
        patch_width, 4, 4, 4, 4,
    )  # fmt: skip
    bound = fast_bound(level, 4, 4, 4, 4)
    assert bound <= BOUND_SCALE * delta
    assert bound <= BOUND_SCALE * brute_force.delta_bound(level, 4, 4, 4, 4)
    if (pattern == "flat" and patch_width <= 5) or (pattern != "noise" and patch_width == 3):
        assert bound > 0.999 * BOUND_SCALE * delta


@pytest.mark.parametrize("vertical", [0, 1, 2])
@pytest.mark.parametrize("horizontal", [0, 1, 2])
def test_the_largest_moments_fit_16_bits(vertical, horizontal):
    """Black and white where a product of polynomials changes its sign, against its negative."""
    level = make_level(source_size=(5, 5), target_size=(5, 5))
    product = np.outer(POLYNOMIALS[5][vertical], POLYNOMIALS[5][horizontal])
    used = level.packing.weights > 0
    level.textures.source[:, :, used] = np.where(product > 0, 255, 0)[:, :, None]
    level.textures.target[2:-2, 2:-2, used] = np.where(product > 0, 0, 255)[:, :, None]
    for texture, moments, first in (
        (level.textures.source, level.textures.source_moments, 2),
        (level.textures.target, level.textures.target_moments, 0),
    ):
        level.passes.patch_moments(
            texture, moments, 5, first, level.packing.style_channel, level.packing.style_channels
        )
    exact = brute_force.delta_bound(level, 2, 2, 2, 2)
    assert fast_bound(level, 2, 2, 2, 2) == pytest.approx(BOUND_SCALE * exact, rel=1e-3)


@pytest.mark.parametrize("weight", [1e-3, 3e4])
def test_weights_of_any_size_give_a_bound(weight):
    level = make_level(patch_width=3, guide_channels=(1, 1), guide_weights=(weight, 1.0))
    metric = make_fast_metric(*vector_sizes(level.textures, 3))
    assignment_delta, may_improve = metric.assignment_delta, metric.may_improve

    @njit
    def decide(textures, omega_sums, weight, y, x, source_y, source_x):
        delta = assignment_delta(textures, y, x, source_y, source_x)
        phi = delta + weight * omega_sums[source_y, source_x]
        return may_improve(textures, omega_sums, weight, y, x, source_y, source_x, phi + 1)

    for y, x in np.ndindex(*level.delta.shape):
        source_y, source_x = level.nnf[-1 - y, -1 - x].tolist()
        assert decide(
            level.textures, level.omega_sums, level.occurrence_weight, y, x, source_y, source_x
        )
