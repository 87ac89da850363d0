"""The numbers of usage on input made by hand."""

import numpy as np
import pytest

from eval.metrics.usage import coverage, distinct_patches, peak_usage, usage_entropy


def test_usage():
    omega = np.array([[0, 0], [4, 12]], np.int32)
    assert coverage(omega) == 0.5
    assert peak_usage(omega, target_patches=16, patch_width=1) == 3
    nnf = np.array([[[1, 2], [1, 2]], [[3, 2], [2, 1]]], np.int32)
    assert distinct_patches(nnf) == 0.75


def test_usage_entropy_is_one_where_every_pixel_is_used_alike():
    assert usage_entropy(np.full((4, 5), 25)) == pytest.approx(1)
    one = np.zeros((4, 5), int)
    one[2, 3] = 500
    assert usage_entropy(one) == 0
    half = np.zeros((4, 4), int)
    half[:2] = 7
    assert usage_entropy(half) == pytest.approx(np.log(8) / np.log(16))
