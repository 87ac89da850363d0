"""Which exemplar a part of the texture comes from."""

from collections.abc import Sequence
from numbers import Real

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError, shown
from stylit_ref.notes import note
from stylit_ref.randomness.random_stream import LABELS, random_stream
from stylit_ref.texture.checks import check_size
from stylit_ref.texture.passes.white_noise import white_noise

FREE_BAND = 4
"""Within so many pixels of a border between labels, a pixel may come from any exemplar."""

LARGEST_CHANGE = 0.02
"""By how much the share of an exemplar may differ from what was asked for."""

_LEVELS = 1 << 16
_BLOBS = 8
"""A map drawn for shares has about so many blobs along the shorter side, half of them a label's."""


def with_free_borders(labels: NDArray[np.uint8], band: int = FREE_BAND) -> NDArray[np.uint8]:
    """Labels that are 0, for any exemplar, within ``band`` pixels of the borders between them.

    The map wraps around.
    """
    from scipy.ndimage import (  # imported late: SciPy takes long to load
        maximum_filter,
        minimum_filter,
    )

    reach = np.arange(-band, band + 1)
    disc = np.hypot(*np.meshgrid(reach, reach)) <= band
    least = minimum_filter(labels, footprint=disc, mode="wrap")
    most = maximum_filter(labels, footprint=disc, mode="wrap")
    return np.where(least == most, labels, 0).astype(np.uint8)


def band_for_shares(labels: NDArray[np.uint8]) -> int:
    """The widest free band with which no share can change by more than :data:`LARGEST_CHANGE`.

    A label can lose all of its free pixels to others, or get all of theirs.
    """
    for band in range(FREE_BAND, 0, -1):
        free = np.bincount(labels[with_free_borders(labels, band) == 0])
        if max(free.max(initial=0), free.sum() - free[1:].min(initial=0)) <= (
            LARGEST_CHANGE * labels.size
        ):
            return band
    return 0


def labels_by_shares(
    shares: Sequence[float],
    exemplars: int,
    size: tuple[int, int],
    seed: int,
    labels: NDArray[np.uint8] | None = None,
) -> NDArray[np.uint8]:
    """Draw a smooth map of labels that wraps around and has these shares, to one pixel.

    Parameters
    ----------
    shares : sequence of float
        One for each exemplar; they are divided by their sum.
    exemplars : int
        How many there are.
    size : tuple of int
        Height and width of the texture.
    seed : int
    labels : optional
        Must be None: a map is given or drawn.

    Returns
    -------
    (height, width) uint8
        From 1.

    Raises
    ------
    InputError
        If they are not one positive number for each exemplar.
    """
    if labels is not None:
        raise InputError("cannot be given with labels; leave one of them out", parameter="shares")
    height, width = check_size(size)
    given = list(shares)
    if len(given) != exemplars or not all(
        isinstance(share, Real) and 0 < share < float("inf") for share in given
    ):
        raise InputError(
            f"is {shown(given)}; it must be a number above 0 for each of the {exemplars} exemplars",
            parameter="shares",
        )
    portions = np.array(given, np.float64) / np.sum(given)
    if not np.allclose(portions, given):
        wanted, told = (", ".join(f"{share:.3g}" for share in each) for each in (given, portions))
        note(f"is {wanted}, which is taken as {told} of the texture", parameter="shares")
    # One label after the other takes the pixels of least rank in a map of its own.
    ends = np.rint(np.cumsum(given) / np.sum(given) * height * width).astype(np.int64)
    labels = np.full(height * width, exemplars, np.uint8)
    remaining = np.arange(height * width)
    for label, number in enumerate(np.diff(ends[:-1], prepend=0), 1):
        order = np.argsort(_blobs((height, width), seed, label)[remaining], kind="stable")
        labels[remaining[order[:number]]] = label
        remaining = np.sort(remaining[order[number:]])
    return labels.reshape(height, width)


def _blobs(size, seed, number):
    """Smooth noise in integers, so that all machines draw the same; it wraps around."""
    noise = np.empty(size, np.int32)
    white_noise(noise, np.arange(_LEVELS, dtype=np.int32), random_stream(seed, LABELS, number))
    blurred = noise.astype(np.int64) << 24
    reach = min(size) // _BLOBS
    for axis in (0, 1) * 3:
        around = [(0, 0), (0, 0)]
        around[axis] = reach + 1, reach
        sums = np.cumsum(np.pad(blurred, around, mode="wrap") // (2 * reach + 1), axis=axis)
        ends = np.arange(size[axis]) + 2 * reach + 1
        blurred = sums.take(ends, axis) - sums.take(ends - 2 * reach - 1, axis)
    return blurred.ravel()
