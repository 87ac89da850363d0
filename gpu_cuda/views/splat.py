"""Carry the pixels of a frame along their motion: a thread for each pixel that lands.

Threads meet on a pixel in any order, so each step takes a least value atomically: first the depth,
then what decides among those of that depth.
"""

import numpy as np
from numba import cuda, types

from gpu_cuda.host.device import device_function, launch
from gpu_cuda.host.memory import empty, fill
from gpu_cuda.views.argument_types import DEPTH, FIELD, FLAGS, PLACES
from gpu_cuda.views.formulae import differ, fixed
from stylit_ref.views.formulae.vectors import ONE

RANKS = types.int64[:, ::1]
NUMBERS = (1 << 32) - 1
NO_RANK = (1 << 63) - 1


@device_function
def least(values, row, column, value):
    """Lower a value to another one, while other threads do so."""
    cuda.atomic.min(values, (row, column), value)


@cuda.jit
def find_nearest_kernel(places, depth, nearest):
    x, y = cuda.grid(2)
    height, width = depth.shape
    if y >= height or x >= width:
        return
    row, column = places[y, x, 0], places[y, x, 1]
    if row >= 0:
        least(nearest, row, column, depth[y, x])


@cuda.jit
def find_closest_kernel(field, places, depth, nearest, ranks):
    x, y = cuda.grid(2)
    height, width = depth.shape
    if y >= height or x >= width:
        return
    row, column = places[y, x, 0], places[y, x, 1]
    if row >= 0 and depth[y, x] == nearest[row, column]:
        away_x = fixed(field[y, x, 0]) + (x - column) * ONE
        away_y = fixed(field[y, x, 1]) + (y - row) * ONE
        # A pixel lands at most half a pixel away, so the distance fits the upper half.
        distance = np.int64(away_x * away_x + away_y * away_y)
        least(ranks, row, column, (distance << 32) | (y * width + x))


@cuda.jit
def take_winners_kernel(ranks, winners):
    column, row = cuda.grid(2)
    height, width = ranks.shape
    if row >= height or column >= width:
        return
    winners[row, column, 0] = winners[row, column, 1] = -1
    if ranks[row, column] != NO_RANK:
        winner = np.int32(ranks[row, column] & NUMBERS)
        winners[row, column, 0], winners[row, column, 1] = winner // width, winner % width


@cuda.jit
def find_beaten_kernel(field, places, winners, beaten, contested):
    x, y = cuda.grid(2)
    if y >= beaten.shape[0] or x >= beaten.shape[1]:
        return
    is_beaten = False
    row, column = places[y, x, 0], places[y, x, 1]
    if row >= 0:
        top, left = winners[row, column, 0], winners[row, column, 1]
        is_beaten = differ(
            fixed(field[y, x, 0]),
            fixed(field[y, x, 1]),
            fixed(field[top, left, 0]),
            fixed(field[top, left, 1]),
        )
        if is_beaten:
            contested[row, column] = True
    beaten[y, x] = is_beaten


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "views: find nearest", find_nearest_kernel, (PLACES, DEPTH, DEPTH)
    yield "views: find closest", find_closest_kernel, (FIELD, PLACES, DEPTH, DEPTH, RANKS)
    yield "views: take winners", take_winners_kernel, (RANKS, PLACES)
    yield "views: find beaten", find_beaten_kernel, (FIELD, PLACES, PLACES, FLAGS, FLAGS)


def splat(field, places, depth, winners):
    """As :func:`stylit_ref.views.passes.splat`."""
    size = depth.shape
    nearest, ranks = empty(size, np.float32), empty(size, np.int64)
    fill(nearest, np.inf)
    fill(ranks, NO_RANK)
    launch(find_nearest_kernel, size, places, depth, nearest)
    launch(find_closest_kernel, size, field, places, depth, nearest, ranks)
    launch(take_winners_kernel, size, ranks, winners)


def find_beaten(field, places, winners, beaten, contested):
    """As :func:`stylit_ref.views.passes.find_beaten`."""
    fill(contested, False)
    launch(find_beaten_kernel, beaten.shape, field, places, winners, beaten, contested)
