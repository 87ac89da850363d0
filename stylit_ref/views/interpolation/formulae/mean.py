"""Means of votes, four bytes in one number at a time, without a division."""

from numba import njit

from stylit_ref.machine.inlined import inlined

PAIR = 0x00FF00FF
"""Every other byte of a pixel; their sums have 16 bits each."""

WIDEST = 15
"""The widest patch whose votes, 225 of up to 255, sum up to less than 2^16."""


@njit
def reciprocal_of(count: int) -> int:
    """2^32 / (2 count), rounded up."""
    return ((1 << 32) + 2 * count - 1) // (2 * count)


@inlined
def mean_of_votes(total: int, count: int, reciprocal: int) -> int:
    """``total / count`` rounded half up, ``floor((2 total + count) / (2 count))``.

    With r = ``reciprocal_of(count)``, r = (2^32 + e) / (2 count) and e < 2 count. For a numerator m
    the product m r / 2^32 exceeds m / (2 count) by less than m / 2^32. That leads to no other whole
    number while m < 2^32 / (2 count). Here m is less than 2^17, and 2 count at most 450.

    Parameters
    ----------
    total : int
        Less than 2^16.
    count : int
        At most 225.
    reciprocal : int
    """
    return ((2 * total + count) * reciprocal) >> 32
