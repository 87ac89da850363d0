"""The S that synthesis begins with: white noise of what may be shown (section 8)."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.randomness.philox import FourWords
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
    pixels = np.flatnonzero(exemplars.clearance).astype(np.int32)
    white_noise(addresses, pixels, stream)
    for label in np.unique(labels[labels > 0]):
        noise = noise_of(exemplars, label, addresses.size, stream).reshape(addresses.shape)
        np.copyto(addresses, noise, where=labels == label)


def noise_of(exemplars: Exemplars, label: int, count: int, stream: FourWords) -> NDArray[np.int32]:
    """So many random addresses of the exemplar ``label``, from 1.

    Raises
    ------
    InputError
        If none of its pixels is known.
    """
    first, beyond = exemplars.bounds[label - 1 : label + 1]
    own = np.flatnonzero(exemplars.clearance.ravel()[first:beyond])
    if not own.size:
        raise InputError(f"exemplar {label} is asked for, and no pixel of it is known")
    noise = np.empty((1, count), np.int32)
    white_noise(noise, (own + first).astype(np.int32), stream)
    return noise[0]
