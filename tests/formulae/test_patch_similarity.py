"""δ: the formula and its fast form against the definition."""

import brute_force
import numpy as np
import pytest
from numba import njit
from small_level import make_level

from stylit_ref.formulae.patch_similarity import delta
from stylit_ref.metric.fast_metric import make_fast_metric
from stylit_ref.metric.textures import vector_sizes

CASES = [
    {"patch_width": 3},
    {"patch_width": 5},
    {"patch_width": 7, "guide_channels": (1, 3), "guide_weights": (1.0, 0.25)},
    {"patch_width": 5, "guide_channels": (3,) * 8, "style_channels": 4},
    {"patch_width": 13, "guide_channels": (1,), "style_channels": 1},
    {"patch_width": 5, "guide_channels": (40,), "style_channels": 2},
    {"patch_width": 3, "guide_channels": (1, 1, 1), "guide_weights": (0.0, 1e-3, 3e4)},
]


@pytest.mark.parametrize("case", CASES, ids=str)
def test_delta_and_its_fast_form_are_the_definition(case):
    level = make_level(source_size=(15, 19), target_size=(14, 16), **case)
    constants = vector_sizes(level.textures, level.patch_width)
    assignment_delta = make_fast_metric(*constants).assignment_delta

    @njit
    def fast_delta(textures, y, x, source_y, source_x):
        return assignment_delta(textures, y, x, source_y, source_x)

    weights = brute_force.weights_of(level.packing)
    for y in range(level.nnf.shape[0]):
        for x in range(level.nnf.shape[1]):
            place = (y, x, *level.nnf[y, x])
            expected = brute_force.delta(
                level.textures.source, level.textures.target, weights, level.patch_width, *place
            )
            assert (
                delta(
                    level.textures.source,
                    level.textures.target,
                    level.textures.weights,
                    level.patch_width,
                    *place,
                )
                == expected
            )
            assert fast_delta(level.textures, *map(int, place)) == expected
            assert level.delta[y, x] == expected


def test_delta_of_extreme_images_does_not_overflow():
    level = make_level(patch_width=13, guide_channels=(24,), style_channels=4)
    level.textures.source[:] = 255
    level.textures.target[:] = 0
    level.update_similarity()
    assert (level.delta == 13 * 13 * 255**2 * int(level.packing.weights.sum())).all()


def test_thesis_weights():
    """Five RGB guides at μ = 2 and an RGB style: 2/15 and 1/3 a channel (3.2)."""
    packing = make_level(guide_channels=(3,) * 5).packing
    weights = packing.weights / 65536
    np.testing.assert_allclose(weights[:15], 2 / 15, atol=1e-5)
    np.testing.assert_allclose(packing.style(weights[None, None])[0, 0], 1 / 3, atol=1e-5)
