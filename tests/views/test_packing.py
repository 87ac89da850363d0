"""Where the spread lies, and what it weighs."""

import numpy as np
import pytest

from stylit_ref.metric.packing import ONE, make_packing
from stylit_ref.views.packing import coherent_packing


def with_spread(guide_sizes, style_channels, style_weight=256):
    packing = make_packing(guide_sizes, style_channels, 2.0, (1.0,) * len(guide_sizes))
    return packing, coherent_packing(packing, style_weight, with_spread=True)


def test_the_spread_takes_a_channel_that_a_style_in_colour_leaves_free():
    packing, coherent = with_spread((3, 3, 3, 3), 3)
    assert packing.channels == coherent.channels == 16
    assert coherent.guide_channels[-1] == 15


@pytest.mark.parametrize("style_channels", [1, 2, 3, 4])
@pytest.mark.parametrize("style_weight", [256, 256 + 4 * 77])
def test_the_spread_weighs_as_much_as_a_channel_of_the_style(style_channels, style_weight):
    _, coherent = with_spread((3, 1), style_channels, style_weight)
    first, last = coherent.style_channel, coherent.guide_channels[-1]
    assert last == first + style_channels
    exact = ONE / style_channels * style_weight / 256
    assert np.allclose(coherent.weights[first : last + 1], exact, rtol=0, atol=2)
    assert len(set(coherent.weights[first : last + 1])) == 1
    assert not coherent.weights[last + 1 :].any()
    pairs = coherent.weights.reshape(-1, 2)
    assert np.all((pairs[:, 0] == pairs[:, 1]) | (pairs[:, 1] == 0))
