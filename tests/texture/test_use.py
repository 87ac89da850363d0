"""The price of places that a texture uses often, against counting them one by one."""

import numpy as np
import pytest
from texture.small_exemplars import blobs

from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.passes.use import price_use
from stylit_ref.texture.session import TextureSession


def counted(session, settings):
    """What each centre costs, by the words of :func:`price_use`."""
    radius, spread = settings.radius, settings.spread
    exemplars = session.exemplars
    valid = exemplars.clearance.reshape(-1, exemplars.stride) > 0
    used = np.zeros(valid.shape, np.int64)
    np.add.at(used.ravel(), session.texture.addresses.ravel().astype(np.int64) % exemplars.plane, 1)
    prices = np.zeros(valid.size, np.int64)
    for centre in exemplars.centres(radius):
        y, x = divmod(int(centre), exemplars.stride)
        square = np.s_[y - radius // 2 : y + radius // 2 + 1, x - radius // 2 : x + radius // 2 + 1]
        share = 256 * used[square].sum() * valid.sum()
        share //= valid[square].sum() * session.texture.addresses.size
        prices[centre] = spread * share // 4
    return prices


@pytest.mark.parametrize("exemplars", [[blobs()], [blobs(), blobs(30, 50, seed=2)]])
def test_prices_are_those_of_counting(exemplars):
    session = TextureSession(exemplars, (33, 52), TextureParams(radius=5), seed=4)
    for _ in range(3):
        session.step()
    prices = np.zeros(session.exemplars.plane, np.int64)
    _, sources, settings = session.fitted(5)
    centres = sources.centres
    price_use(session.texture.addresses, sources.clearance, centres, settings, prices)
    assert prices[centres].min() < prices[centres].max()
    np.testing.assert_array_equal(prices, counted(session, settings))
