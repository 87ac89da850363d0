"""Which entries go on in a warm frame, against a dilation."""

import numpy as np
import pytest
from scipy.ndimage import binary_dilation

from stylit_ref.realtime.passes import mark_moving


@pytest.mark.parametrize("grid", [(9, 11), (1, 8), (7, 1), (1, 1)])
@pytest.mark.parametrize("share", [0.0, 0.1, 1.0])
def test_entries_that_moved_and_those_around_them(grid, share):
    random = np.random.default_rng(sum(grid))
    before = random.integers(0, 1 << 20, grid).astype(np.int32)
    moved = random.random(grid) < share
    moving = np.full(grid, 5, np.uint8)
    mark_moving(before, before + moved, moving)
    assert np.array_equal(moving, binary_dilation(moved, np.ones((3, 3))))
