"""Where a pixel of an image is, and the type of an image that kernels take."""

from numba import types

from gpu_cuda.host.argument_types import INT
from gpu_cuda.host.device import device_function, launch
from stylit_ref.realtime.passes.image import Image

BYTES = types.uint8[::1]
IMAGE = types.NamedTuple((BYTES, INT, INT, INT, INT), Image)


@device_function
def address(image, y, x, lanes):
    """The first byte of a pixel; y and x count from the interior's first."""
    return ((y + image.border) * image.stride + x + image.border) * lanes


@device_function
def nearest(place, border, side):
    """The coordinate of the interior's pixel that one of the whole image repeats."""
    return min(max(place - border, 0), side - 1)


def launch_whole(kernel, image, *arguments):
    """Run a kernel with a thread for every pixel, those of the border included."""
    launch(kernel, (image.height + 2 * image.border, image.stride), *arguments)
