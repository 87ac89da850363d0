"""Ω, W and ρ."""

import brute_force
import numpy as np
import pytest
from small_level import make_level

from stylit_ref.formulae.patch_penalization import (
    omega_best,
    omega_sum,
    update_omega_sums,
    update_patch_omega,
)
from stylit_ref.metric.packing import occurrence_weight


@pytest.mark.parametrize("patch_width", [3, 5, 7])
def test_omega_sum_is_of_the_patch(patch_width):
    level = make_level(patch_width=patch_width)
    for centre in ((3, 3), (6, 9), (9, 13)):
        expected = brute_force.omega_sum(level.omega, patch_width, *centre)
        assert omega_sum(level.omega, patch_width, *centre) == expected


@pytest.mark.parametrize("patch_width", [3, 5, 7])
def test_updates_follow_an_assignment(patch_width):
    """Moving one patch by updates gives Ω and W of a recount, at the borders too."""
    level = make_level(patch_width=patch_width)
    radius = patch_width // 2
    height, width = level.omega.shape
    corners = [(radius, radius), (height - 1 - radius, width - 1 - radius), (height // 2, radius)]
    for pixel, (new_y, new_x) in enumerate(corners):
        old_y, old_x = level.nnf[0, pixel]
        for update, array in (
            (update_patch_omega, level.omega),
            (update_omega_sums, level.omega_sums),
        ):
            update(array, patch_width, new_y, new_x, 1)
            update(array, patch_width, old_y, old_x, -1)
        level.nnf[0, pixel] = new_y, new_x
    omega, omega_sums = level.omega.copy(), level.omega_sums.copy()
    level.init_occurrence_map()
    np.testing.assert_array_equal(omega, level.omega)
    np.testing.assert_array_equal(omega_sums, level.omega_sums)


def test_uniform_use_costs_lambda():
    """Where every pixel is used ω_best times, ρ is 1 and λρ is λ (thesis 2.1)."""
    source_pixels, target_patches, patch_width = 400, 1600, 5
    best = omega_best(patch_width, source_pixels, target_patches)
    assert best == 100
    weight = occurrence_weight(10000, patch_width, source_pixels, target_patches)
    assert weight * patch_width**2 * best / 65536 == pytest.approx(10000, rel=1e-6)
