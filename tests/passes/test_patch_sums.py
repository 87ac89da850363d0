import numpy as np
import pytest
from small_level import make_level

from stylit_ref.formulae.bounded_metric import sum_width


@pytest.mark.parametrize("patch_width", [3, 5, 11, 13])
def test_sums_over_patches(patch_width):
    level = make_level(patch_width=patch_width, source_size=(16, 15), target_size=(14, 3))
    reach, radius = sum_width(patch_width) // 2, patch_width // 2
    source, target = level.textures.source.astype(int), level.textures.target.astype(int)
    for y in range(radius, 16 - radius):
        for x in range(radius, 15 - radius):
            block = source[y - reach : y + reach + 1, x - reach : x + reach + 1]
            assert (level.textures.source_sums[y, x] == block.sum(axis=(0, 1))).all()
    for y, x in np.ndindex(14, 3):
        top, left = y + radius - reach, x + radius - reach
        block = target[top : top + 2 * reach + 1, left : left + 2 * reach + 1]
        assert (level.textures.target_sums[y, x] == block.sum(axis=(0, 1))).all()
