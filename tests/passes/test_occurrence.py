"""Ω and W of a whole NNF, and what never changes about them."""

import brute_force
import numpy as np
import pytest
from small_level import make_level

from stylit_ref import passes


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


def test_many_rows_are_counted_as_few_are():
    random = np.random.default_rng(0)
    nnf = random.integers(0, (150, 20), (200, 20, 2), dtype=np.int32)
    nnf[70:75] = -1
    counts = np.zeros((150, 20), np.int32)
    for y, x in nnf[nnf[:, :, 0] >= 0]:
        counts[y, x] += 1
    np.testing.assert_array_equal(passes.count_assignments(nnf, counts.shape), counts)
    sums = passes.box_sum(counts, 5)
    assert sums.dtype == np.int32
    for y in range(150):
        window = counts[max(0, y - 2) : y + 3]
        for x in range(20):
            assert sums[y, x] == window[:, max(0, x - 2) : x + 3].sum()
