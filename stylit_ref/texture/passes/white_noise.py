"""White noise: the S that synthesis begins with (section 8)."""

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.randomness.philox import FourWords, uniform_below
from stylit_ref.randomness.random_stream import random_words


@kernel()
def _white_noise(addresses, pixels, stream):
    height, width = addresses.shape
    for y in prange(height):
        for x in range(width):
            words = random_words(stream, y * width + x, 0)
            addresses[y, x] = pixels[uniform_below(words[0], pixels.size)]


def white_noise(addresses: NDArray[np.int32], pixels: NDArray[np.int32], stream: FourWords) -> None:
    """Give every pixel of S an address of ``pixels``, each as likely.

    Parameters
    ----------
    addresses : (H, W) int32
        Receives them.
    pixels : (n,) int32
    stream : tuple of 4 uint32
    """
    _white_noise(addresses, pixels, stream)
