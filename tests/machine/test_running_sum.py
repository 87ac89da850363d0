"""Running sums of eight elements at a time."""

import numpy as np
import pytest
from numba import njit

from stylit_ref.machine.running_sum import LANES, add_up


@njit
def add_up_from(values, first, total):
    return add_up(values, first, total)


@pytest.mark.parametrize("first", [0, 3])
@pytest.mark.parametrize("total", [0, -70_000])
def test_eight_elements_become_their_sums_and_no_other_changes(first, total):
    values = np.random.default_rng(1).integers(-1 << 20, 1 << 20, 13).astype(np.int32)
    expected = values.copy()
    expected[first : first + LANES] = total + np.cumsum(values[first : first + LANES])
    last = add_up_from(values, first, np.int32(total))
    np.testing.assert_array_equal(values, expected)
    assert last == expected[first + LANES - 1]
