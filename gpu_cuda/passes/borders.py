"""Fill the border around an image: each border pixel takes the value of the nearest inside."""

import numpy as np
from numba import cuda

from gpu_cuda.host.argument_types import IMAGE, INT
from gpu_cuda.host.device import launch
from gpu_cuda.host.memory import empty


@cuda.jit
def repeat_edge_kernel(image, first, padded, radius, first_channel, channels):
    """Copy channels of an image whose first pixel is ``image[first, first]`` to a padded one.

    Both may be the same array: then its border is updated and its inside stays as it is.
    """
    x, y = cuda.grid(2)
    if y >= padded.shape[0] or x >= padded.shape[1]:
        return
    from_y = first + min(max(y - radius, 0), padded.shape[0] - 2 * radius - 1)
    from_x = first + min(max(x - radius, 0), padded.shape[1] - 2 * radius - 1)
    for c in range(first_channel, first_channel + channels):
        padded[y, x, c] = image[from_y, from_x, c]


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "repeat edge", repeat_edge_kernel, (IMAGE, INT, IMAGE, INT, INT, INT)


def repeat_edge(image, radius):
    """As :func:`stylit_ref.passes.repeat_edge`, on device arrays."""
    height, width, channels = image.shape
    padded = empty((height + 2 * radius, width + 2 * radius, channels), np.uint8)
    launch(repeat_edge_kernel, padded.shape[:2], image, 0, padded, radius, 0, channels)
    return padded


def repeat_own_edge(padded, radius, first_channel, channels):
    """Update the border of a padded image in some channels."""
    launch(
        repeat_edge_kernel, padded.shape[:2],
        padded, radius, padded, radius, first_channel, channels,
    )  # fmt: skip
