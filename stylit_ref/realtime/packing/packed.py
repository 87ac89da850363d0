"""What every packing offers, and a frame packed by one into arrays of its own."""

from collections.abc import Mapping
from typing import Protocol

import numpy as np
from numpy.typing import NDArray


class Packing(Protocol):
    """What makes the bytes of a pixel."""

    @property
    def names(self) -> tuple[str, ...]:
        """The buffers that it reads."""
        ...

    @property
    def channels(self) -> tuple[str, ...]:
        """For each byte of a pixel the name of its buffer."""
        ...

    def pack_into(
        self,
        buffers: Mapping[str, NDArray[np.uint8]],
        out: NDArray[np.uint8],
        labels: NDArray[np.uint8] | None = None,
    ) -> None:
        """Write a frame's bytes, and its labels if they are asked for."""
        ...


def pack(
    packing: Packing, buffers: Mapping[str, NDArray[np.uint8]]
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """A frame's bytes and labels.

    Parameters
    ----------
    packing : Packing
    buffers : mapping of str to (H, W) or (H, W, 3) uint8

    Returns
    -------
    features : (H, W, C) uint8
    labels : (H, W) uint8

    Raises
    ------
    InputError
        If the buffers are not those that the packing reads.
    """
    size = next((np.shape(buffer)[:2] for buffer in buffers.values()), (0, 0))
    features = np.zeros((*size, len(packing.channels)), np.uint8)
    labels = np.zeros(size, np.uint8)
    packing.pack_into(buffers, features, labels)
    return features, labels
