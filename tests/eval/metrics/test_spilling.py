"""The numbers of spilling on input made by hand."""

import numpy as np

from eval.metrics.spilling import spilling


def test_spilling_is_where_source_and_target_are_different_things():
    source_ids = np.zeros((4, 6, 3), np.uint8)
    source_ids[:, 3:, 1] = 255
    target_ids = np.zeros((2, 3, 3), np.uint8)
    target_ids[1, :, 1] = 255
    nnf = np.array([[[0, 0], [1, 2], [2, 3]], [[3, 3], [0, 5], [3, 2]]], np.int32)
    expected = [[False, False, True], [False, False, True]]
    np.testing.assert_array_equal(spilling(nnf, (source_ids, target_ids)), expected)
