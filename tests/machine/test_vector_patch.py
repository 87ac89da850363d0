"""Sums of weighted squares of patches against NumPy."""

import numpy as np
import pytest
from numba import njit

from stylit_ref.machine.vector_patch import SLACK, alike_in_pairs, make_patch_ssd


@pytest.mark.parametrize("pairs", [False, True])
@pytest.mark.parametrize(("rows", "length"), [(1, 48), (3, 16), (5, 80), (13, 208)])
@pytest.mark.parametrize("extreme", [False, True])
def test_ssd(rows, length, pairs, extreme):
    random = np.random.default_rng(rows + length)
    stride, used = length + 7, length - 4
    pixels = random.integers(0, 256, rows * stride + SLACK, np.uint8)
    patch = random.integers(0, 256, (rows, length)).astype(np.int16)
    largest = (2**31 - 1) // (rows * used * 255**2)
    weights = random.integers(0, min(largest, 128) + 1, length).astype(np.int16)
    if extreme:
        pixels[:], patch[:], weights[:] = 255, 0, min(largest, 128)
        if not pairs:
            weights[1] = 0
    weights[used:] = 0
    patch[:, used:] = -(2**15)  # whatever lies behind a row weighs nothing
    if pairs:
        weights[1::2] = weights[::2]
    ssd = make_patch_ssd(rows, length)

    @njit
    def run(pixels, patch, weights):
        return ssd(pixels, 3, stride, patch, 0, weights, alike_in_pairs(weights))

    assert alike_in_pairs.py_func(weights) == pairs
    read = np.stack([pixels[3 + row * stride :][:length] for row in range(rows)]).astype(np.int64)
    expected = (weights * ((read - patch) ** 2)).sum()
    assert run(pixels, patch.ravel(), weights) == expected
