"""An entry of the NNF: y and x of its patch's centre in the source, 16 bits each."""

import numpy as np
from numba import njit
from numpy.typing import NDArray

LARGEST_SIDE = (1 << 15) - 1
"""A side of more pixels does not fit an entry."""


@njit
def packed(y: int, x: int) -> np.int32:
    """Y and x, each below 32768, in one number."""
    return np.int32(y << 16 | x)


@njit
def row_of(entry: int) -> int:
    """Y."""
    return np.int64(entry >> 16)


@njit
def column_of(entry: int) -> int:
    """X."""
    return np.int64(entry & 0xFFFF)


def places_of(entries: NDArray[np.int32]) -> NDArray[np.int32]:
    """Y and x of entries of any shape, along a last axis."""
    return np.stack([entries >> 16, entries & 0xFFFF], -1).astype(np.int32)


def entries_of(places: NDArray[np.int32]) -> NDArray[np.int32]:
    """What :func:`places_of` takes apart."""
    return places[..., 0] << 16 | places[..., 1]
