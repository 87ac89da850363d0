"""Counter-based random numbers: Philox4x32-10 (Salmon et al. 2011, Random123).

A draw depends only on its counter and key. So every pixel draws the same numbers in any thread,
block or device, and there is no state to keep (the thesis keeps a ``curandState`` for each pixel,
section 3.3).
"""

import numpy as np
from numba import njit

MULTIPLIER_0 = np.uint64(0xD2511F53)
MULTIPLIER_1 = np.uint64(0xCD9E8D57)
WEYL_0 = np.uint32(0x9E3779B9)
WEYL_1 = np.uint32(0xBB67AE85)
ROUNDS = 10

# A draw of random numbers; or what tells one stream of them from another.
FourWords = tuple[np.uint32, np.uint32, np.uint32, np.uint32]


@njit
def philox4x32(
    counter_0: int, counter_1: int, counter_2: int, counter_3: int, key_0: int, key_1: int
) -> FourWords:
    """Encrypt a 128-bit counter with a 64-bit key into four random words.

    Parameters
    ----------
    counter_0, counter_1, counter_2, counter_3, key_0, key_1 : uint32

    Returns
    -------
    tuple of 4 uint32
    """
    c0, c1 = np.uint32(counter_0), np.uint32(counter_1)
    c2, c3 = np.uint32(counter_2), np.uint32(counter_3)
    k0, k1 = np.uint32(key_0), np.uint32(key_1)
    for _ in range(ROUNDS):
        product_0 = np.uint64(c0) * MULTIPLIER_0
        product_1 = np.uint64(c2) * MULTIPLIER_1
        c0 = np.uint32(np.uint32(product_1 >> np.uint64(32)) ^ c1 ^ k0)
        c1 = np.uint32(product_1 & np.uint64(0xFFFFFFFF))
        c2 = np.uint32(np.uint32(product_0 >> np.uint64(32)) ^ c3 ^ k1)
        c3 = np.uint32(product_0 & np.uint64(0xFFFFFFFF))
        k0 = np.uint32((np.uint64(k0) + np.uint64(WEYL_0)) & np.uint64(0xFFFFFFFF))
        k1 = np.uint32((np.uint64(k1) + np.uint64(WEYL_1)) & np.uint64(0xFFFFFFFF))
    return c0, c1, c2, c3


@njit
def uniform_below(word: int, n: int) -> int:
    """Map a random word to an integer in ``[0, n)``: ``floor(word * n / 2**32)``."""
    return np.int64((np.uint64(word) * np.uint64(n)) >> np.uint64(32))
