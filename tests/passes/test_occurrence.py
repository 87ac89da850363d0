"""Ω and W of a whole NNF, and what never changes about them."""

import brute_force
import numpy as np
import pytest
from small_level import make_level


@pytest.mark.parametrize("patch_width", [3, 5, 7])
def test_occurrence_map_is_a_count(patch_width):
    level = make_level(patch_width=patch_width)
    omega = brute_force.omega(level.nnf, level.omega.shape, patch_width)
    np.testing.assert_array_equal(level.omega, omega)
    assert level.omega.sum() == patch_width**2 * level.nnf[:, :, 0].size
    radius = patch_width // 2
    for y in range(radius, omega.shape[0] - radius):
        for x in range(radius, omega.shape[1] - radius):
            assert level.omega_sums[y, x] == brute_force.omega_sum(omega, patch_width, y, x)


def test_masked_pixels_do_not_count():
    masked = np.zeros((14, 12), bool)
    masked[:7] = True
    level = make_level(masked=masked)
    assert level.omega.sum() == 25 * 7 * 12
