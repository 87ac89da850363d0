"""Shift a picture to a neighbouring frame, at any level."""

import numpy as np
from numba import cuda

from gpu_cuda.host.argument_types import IMAGE, INT
from gpu_cuda.host.device import launch
from gpu_cuda.views.argument_types import FIELD, FLAGS, PLACES
from gpu_cuda.views.formulae import representative, shifted


@cuda.jit
def shift_map_kernel(motion, visible, depth, places):
    x, y = cuda.grid(2)
    height, width = places.shape[:2]
    if y >= height or x >= width:
        return
    places[y, x, 0] = places[y, x, 1] = -1
    j, i = representative(y, depth), representative(x, depth)
    dx, dy = np.float64(motion[j, i, 0]), np.float64(motion[j, i, 1])
    if visible[j, i] and abs(dx) <= motion.shape[1] and abs(dy) <= motion.shape[0]:
        row, column = shifted(y, dy, depth), shifted(x, dx, depth)
        if 0 <= row < height and 0 <= column < width:
            places[y, x, 0], places[y, x, 1] = row, column


@cuda.jit
def shift_picture_kernel(picture, places, own, guide):
    x, y = cuda.grid(2)
    if y >= places.shape[0] or x >= places.shape[1]:
        return
    row, column = places[y, x, 0], places[y, x, 1]
    for c in range(own.shape[2]):
        guide[y, x, c] = own[y, x, c] if row < 0 else picture[row, column, c]


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "views: shift map", shift_map_kernel, (FIELD, FLAGS, INT, PLACES)
    yield "views: shift picture", shift_picture_kernel, (IMAGE, PLACES, IMAGE, IMAGE)


def shift_map(motion, visible, depth, places):
    """As :func:`stylit_ref.views.passes.shift_map`."""
    launch(shift_map_kernel, places.shape[:2], motion, visible, depth, places)


def shift_picture(picture, places, own, guide):
    """As :func:`stylit_ref.views.passes.shift_picture`."""
    launch(shift_picture_kernel, places.shape[:2], picture, places, own, guide)
