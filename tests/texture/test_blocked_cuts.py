"""A cut that cannot go anywhere stays in its table."""

import numpy as np

from stylit_ref.texture.formulae.polar import BLOCKED
from stylit_ref.texture.passes import best_cuts


def test_where_every_cut_is_blocked_the_path_has_columns_of_the_table():
    """It cost nothing to go through the columns beside the table; then beyond all memory."""
    rows, columns, jump = 40, 3, 4
    crossing = np.full((rows, columns + 2 * jump), BLOCKED, np.int32)
    crossing[:, jump:-jump] = 5
    crossing[7, jump:-jump] = BLOCKED
    steps = np.zeros_like(crossing)
    totals = np.empty((rows + 1, crossing.shape[1]), np.int32)
    paths, costs = np.empty((1, rows), np.int32), np.empty(1, np.int32)
    best_cuts(crossing, steps, jump, np.zeros_like(crossing[0]), totals, paths, costs)
    assert costs[0] >= BLOCKED // 2
    assert 0 <= paths.min() <= paths.max() < columns
