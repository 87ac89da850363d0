"""Find where each pixel's point lies in the views around, and fetch what their NNFs have there."""

import numpy as np
from numba import cuda, types

from gpu_cuda.host.argument_types import MAP, NUMBERS
from gpu_cuda.host.device import launch
from gpu_cuda.interpolation.formulae import column_of, packed, row_of, shifted

MOTION, LAYERS = types.float32[:, :, :, ::1], types.int32[:, :, ::1]


@cuda.jit
def shift_views_kernel(motion, labels, beside, view_labels, views, places):
    x, y = cuda.grid(2)
    height, width = labels.shape
    if y >= height or x >= width:
        return
    near_y, near_x = beside[y, x, 0], beside[y, x, 1]
    for k in range(places.shape[0]):
        dx, dy = np.float64(motion[k, near_y, near_x, 0]), np.float64(motion[k, near_y, near_x, 1])
        is_near = abs(dx) <= width and abs(dy) <= height
        row, column = np.int64(y), np.int64(x)
        if is_near:
            row, column = shifted(row, dy, 0), shifted(column, dx, 0)
        inner_y, inner_x = min(max(row, 0), height - 1), min(max(column, 0), width - 1)
        is_inside = is_near and row == inner_y and column == inner_x
        place = packed(inner_y, inner_x)
        if is_inside and view_labels[views[k], inner_y, inner_x] == labels[near_y, near_x]:
            places[k, y, x] = place
        else:
            places[k, y, x] = ~place


@cuda.jit
def fetch_kernel(nnfs, views, places, candidates, nnf):
    x, y = cuda.grid(2)
    if y >= nnf.shape[0] or x >= nnf.shape[1]:
        return
    chosen = np.int32(-1)
    for k in range(places.shape[0]):
        place, entry = places[k, y, x], np.int32(-1)
        if place >= 0:
            entry = nnfs[views[k], row_of(place), column_of(place)]
        candidates[k, y, x] = entry
        if chosen < 0:
            chosen = entry
    if chosen < 0:
        place = ~places[0, y, x]
        chosen = nnfs[views[0], row_of(place), column_of(place)]
    nnf[y, x] = chosen


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    arguments = MOTION, MAP, LAYERS, LAYERS, NUMBERS, LAYERS
    yield "interpolation: shift", shift_views_kernel, arguments
    yield "interpolation: fetch", fetch_kernel, (LAYERS, NUMBERS, LAYERS, LAYERS, MAP)


def shift(motion, labels, beside, view_labels, views, places):
    """As :func:`stylit_ref.views.interpolation.passes.shift`."""
    launch(shift_views_kernel, labels.shape, motion, labels, beside, view_labels, views, places)


def fetch(nnfs, views, places, candidates, nnf):
    """As :func:`stylit_ref.views.interpolation.passes.fetch`."""
    launch(fetch_kernel, nnf.shape, nnfs, views, places, candidates, nnf)
