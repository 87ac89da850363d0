"""Find what lies beside something nearer."""

import numpy as np
from numba import cuda

from gpu_cuda.host.argument_types import INT
from gpu_cuda.host.device import launch
from gpu_cuda.views.argument_types import FLAGS, INVERSE, PLACES
from gpu_cuda.views.formulae import is_nearer, is_step


@cuda.jit
def find_rims_kernel(inverse, rims):
    x, y = cuda.grid(2)
    height, width = inverse.shape
    if y >= height or x >= width:
        return
    is_rim = False
    for turn in range(4):
        down = (turn - 1) * (1 - turn % 2)  # -1, 0, 1, 0
        right = (turn - 2) * (turn % 2)  # 0, -1, 0, 1
        row, column = y + down, x + right
        if 0 <= row < height and 0 <= column < width:
            near, far = inverse[y, x], inverse[row, column]
            before, behind = 2 * near - far, 2 * far - near
            if 0 <= y - down < height and 0 <= x - right < width:
                before = inverse[y - down, x - right]
            if 0 <= row + down < height and 0 <= column + right < width:
                behind = inverse[row + down, column + right]
            is_rim |= is_step(before, near, far, behind)
    rims[y, x] = is_rim


@cuda.jit
def take_nearer_kernel(inverse, rims, is_close, reach, places):
    x, y = cuda.grid(2)
    height, width = inverse.shape
    if y >= height or x >= width:
        return
    places[y, x, 0], places[y, x, 1] = y, x
    if not is_close[y, x]:
        return
    closest, nearest = reach * reach + 1, np.inf
    for row in range(max(y - reach, 0), min(y + reach + 1, height)):
        for column in range(max(x - reach, 0), min(x + reach + 1, width)):
            if rims[row, column]:
                away = (row - y) * (row - y) + (column - x) * (column - x)
                there = inverse[row, column]
                wins = away < closest or (away == closest and there > nearest)
                if wins and is_nearer(there, inverse[y, x]):
                    closest, nearest = away, there
                    places[y, x, 0], places[y, x, 1] = row, column
    if closest <= reach * reach:
        rim_y, rim_x = places[y, x, 0], places[y, x, 1]
        row = rim_y + (rim_y > y) - (rim_y < y)
        column = rim_x + (rim_x > x) - (rim_x < x)
        is_inside = 0 <= row < height and 0 <= column < width
        if is_inside and not is_nearer(inverse[rim_y, rim_x], inverse[row, column]):
            places[y, x, 0], places[y, x, 1] = row, column


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "views: find rims", find_rims_kernel, (INVERSE, FLAGS)
    yield "views: take nearer", take_nearer_kernel, (INVERSE, FLAGS, FLAGS, INT, PLACES)


def find_rims(inverse, rims):
    """As :func:`stylit_ref.views.passes.find_rims`."""
    launch(find_rims_kernel, inverse.shape, inverse, rims)


def take_nearer(inverse, rims, is_close, reach, places):
    """As :func:`stylit_ref.views.passes.take_nearer`."""
    launch(take_nearer_kernel, inverse.shape, inverse, rims, is_close, reach, places)
