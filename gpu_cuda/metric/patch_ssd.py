"""δ in one thread (SSD, thesis 3.2): it reads four channels at once and stops at a limit.

A texture is read as a flat array of words, four packed channels each. Differences and their
squares fit 32 bits. Two neighbouring channels share a weight (that of the first: the second may be
padding), so their part of δ takes one multiplication to 64 bits. Indices are unsigned: with signed
ones, Numba would check at every read for negative indices, which count from the end.
"""

import numpy as np
from numba import njit

WORD_CHANNELS = 4


@njit
def squared_difference(word_p, word_q, shift):
    """(f^P - f^Q)² of the channel that begins at a bit of two words, uint32."""
    byte = np.uint32(255)
    difference = np.int32(np.int32((word_p >> shift) & byte) - np.int32((word_q >> shift) & byte))
    return np.uint32(difference * difference)


def make_patch_ssd(patch_width, channels, first_channel):
    """Compile the weighted SSD of two patches over some of their packed channels.

    Parameters
    ----------
    patch_width : int
    channels : int
        Channels from this one on are left out; their weights are 0.
    first_channel : int
        Even, as neighbouring channels share a weight.

    Returns
    -------
    callable
        ``(target, first_p, pixel_p, row_p, source, first_q, pixel_q, row_q, weights, limit)
        -> int64``: the fixed-point sum, or a part of it that reaches ``limit``. ``target`` and
        ``source`` are (n,) uint32; a patch begins at word ``first``, its next pixel is ``pixel``
        words further, its next row ``row`` words. ``weights`` are (C,) int64 of at most 32 bits.
    """
    word_pairs = WORD_CHANNELS // 2
    first_word, end_word = first_channel // WORD_CHANNELS, -(-channels // WORD_CHANNELS)
    first_pair = first_channel // 2

    @njit
    def patch_ssd(target, first_p, pixel_p, row_p, source, first_q, pixel_q, row_q, weights, limit):
        total = np.int64(0)
        row_at_p, row_at_q = np.uint64(first_p), np.uint64(first_q)
        for _ in range(patch_width):
            at_p, at_q = row_at_p, row_at_q
            for _ in range(patch_width):
                for word in range(first_word, end_word):
                    word_p = target[at_p + np.uint64(word)]
                    word_q = source[at_q + np.uint64(word)]
                    for pair in range(word_pairs):
                        at_pair = word * word_pairs + pair
                        if at_pair < first_pair:
                            continue
                        shift = np.uint32(16 * pair)
                        squares = np.uint32(
                            squared_difference(word_p, word_q, shift)
                            + squared_difference(word_p, word_q, shift + np.uint32(8))
                        )
                        weight = np.uint64(np.uint32(weights[np.uint64(2 * at_pair)]))
                        total += np.int64(weight * np.uint64(squares))
                at_p += np.uint64(pixel_p)
                at_q += np.uint64(pixel_q)
            if total >= limit:
                break
            row_at_p += np.uint64(row_p)
            row_at_q += np.uint64(row_q)
        return total

    return patch_ssd
