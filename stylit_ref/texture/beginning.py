"""The S that synthesis begins with: white noise of what may be shown (section 8)."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.randomness.random_stream import WHITE_NOISE, random_stream
from stylit_ref.texture.exemplars import Exemplars
from stylit_ref.texture.passes.white_noise import white_noise


def begin_with_noise(
    addresses: NDArray[np.int32], exemplars: Exemplars, labels: NDArray[np.uint8], seed: int
) -> None:
    """Give every pixel of S a random address; a pixel with a label gets one of its exemplar.

    Parameters
    ----------
    addresses : (H, W) int32
        Receives them.
    exemplars : Exemplars
    labels : (H, W) uint8
        Numbers of exemplars, from 1; (1, 1) zeros without.
    seed : int

    Raises
    ------
    InputError
        If no pixel is known of an exemplar that has a label.
    """
    stream = random_stream(seed, WHITE_NOISE)
    pixels = np.flatnonzero(exemplars.valid).astype(np.int32)
    white_noise(addresses, pixels, stream)
    for label in np.unique(labels[labels > 0]):
        least, beyond = np.searchsorted(pixels, exemplars.bounds[label - 1 : label + 1])
        if least == beyond:
            raise InputError(
                f"has pixels of exemplar {label}, of which no pixel is known", parameter="labels"
            )
        noise = np.empty_like(addresses)
        white_noise(noise, pixels[least:beyond], stream)
        np.copyto(addresses, noise, where=labels == label)
