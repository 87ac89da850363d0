"""How much each part of the exemplars is used in S, as a price of candidates."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.texture.passes.layout import Settings


@kernel(parallel=False)
def _price_use(addresses, clearance, centres, settings, prices):
    stride, plane, half = settings.stride, settings.plane, settings.radius // 2
    # Sums over all that is above and to the left; the first row and column are 0.
    used = np.zeros((plane // stride + 1, stride + 1), np.int64)
    valid = np.zeros_like(used)
    for address in addresses.ravel():
        at = np.int64(address) % plane
        used[at // stride + 1, at % stride + 1] += 1
    for y in range(1, used.shape[0]):
        used_here, valid_here = np.int64(0), np.int64(0)
        for x in range(1, stride + 1):
            used_here += used[y, x]
            valid_here += clearance[(y - 1) * stride + x - 1] > 0
            used[y, x] = used[y - 1, x] + used_here
            valid[y, x] = valid[y - 1, x] + valid_here
    total = valid[-1, -1]
    for k in range(centres.size):
        y, x = centres[k] // stride, centres[k] % stride
        top, bottom, left, right = y - half, y + half + 1, x - half, x + half + 1
        around = used[bottom, right] - used[top, right] - used[bottom, left] + used[top, left]
        area = valid[bottom, right] - valid[top, right] - valid[bottom, left] + valid[top, left]
        share = 256 * around * total // (area * addresses.size)
        prices[centres[k]] = (settings.spread * share) >> 2


def price_use(
    addresses: NDArray[np.int32],
    clearance: NDArray[np.uint16],
    centres: NDArray[np.int32],
    settings: Settings,
    prices: NDArray[np.int64],
) -> None:
    """Price the use that S makes of the square of side R around each centre.

    Parameters
    ----------
    addresses : (H, W) int32
        S.
    clearance : (plane,) uint16
    centres : (m,) int32
        Addresses where patches may have their centres.
    settings : Settings
    prices : (plane,) int64
        Receive at the centres ``spread`` times 64, where S uses the valid pixels there as often as
        it uses those of the exemplars on the mean; in proportion elsewhere.
    """
    _price_use(addresses, clearance, centres, settings, prices)
