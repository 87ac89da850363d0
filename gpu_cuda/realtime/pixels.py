"""Put pixels into an image with a border: a caller's, its own edge, or the style."""

from numba import cuda

from gpu_cuda.host.argument_types import INT
from gpu_cuda.host.device import launch
from gpu_cuda.realtime.image import BYTES, IMAGE, address, launch_whole, nearest
from stylit_ref.machine.vector_patch import STYLE_LANES


@cuda.jit
def fill_image_kernel(pixels, channels, image, lanes):
    x, y = cuda.grid(2)
    if x >= image.stride or y >= image.height + 2 * image.border:
        return
    row = nearest(y, image.border, image.height)
    column = nearest(x, image.border, image.width)
    start = (row * image.width + column) * channels
    to = (y * image.stride + x) * lanes
    for c in range(channels):
        image.values[to + c] = pixels[start + c]


@cuda.jit
def extend_kernel(image, lanes):
    x, y = cuda.grid(2)
    if x >= image.stride or y >= image.height + 2 * image.border:
        return
    row = nearest(y, image.border, image.height)
    column = nearest(x, image.border, image.width)
    start = address(image, row, column, lanes)
    to = (y * image.stride + x) * lanes
    if start != to:
        for c in range(lanes):
            image.values[to + c] = image.values[start + c]


@cuda.jit
def insert_style_kernel(style, source, top, bottom, lanes):
    x, y = cuda.grid(2)
    if x >= style.stride or y >= bottom - top:
        return
    pixel = (top + y) * style.stride + x
    for c in range(STYLE_LANES):
        source.values[(pixel + 1) * lanes - STYLE_LANES + c] = style.values[pixel * STYLE_LANES + c]


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "realtime: fill", fill_image_kernel, (BYTES, INT, IMAGE, INT)
    yield "realtime: extend", extend_kernel, (IMAGE, INT)
    yield "realtime: insert style", insert_style_kernel, (IMAGE, IMAGE, INT, INT, INT)


def make_fill(channels, lanes):
    """As :func:`stylit_ref.realtime.passes.make_fill`."""

    def fill(pixels, image):
        launch_whole(fill_image_kernel, image, pixels, channels, image, lanes)

    return fill


def make_extend(lanes):
    """As :func:`stylit_ref.realtime.passes.make_extend`."""

    def extend(image):
        launch_whole(extend_kernel, image, image, lanes)

    return extend


def make_insert_style(lanes):
    """As :func:`stylit_ref.realtime.passes.make_insert_style`."""

    def insert_style(style, source, top, bottom):
        size = bottom - top, style.stride
        launch(insert_style_kernel, size, style, source, top, bottom, lanes)

    return insert_style
