"""Mix pictures, by weights of the whole or of what is not masked."""

import numpy as np
from numba import cuda, types

from gpu_cuda.host.argument_types import IMAGE, NUMBERS
from gpu_cuda.host.device import launch
from gpu_cuda.interpolation.formulae import column_of, row_of, weighted_mean
from gpu_cuda.interpolation.shift import LAYERS

PICTURES = types.uint8[:, :, :, ::1]


@cuda.jit
def mix_kernel(pictures, weights, mixed):
    x, y = cuda.grid(2)
    if y >= mixed.shape[0] or x >= mixed.shape[1]:
        return
    for c in range(mixed.shape[2]):
        total, whole = np.int64(0), np.int64(0)
        for k in range(pictures.shape[0]):
            total += weights[k] * np.int64(pictures[k, y, x, c])
            whole += weights[k]
        mixed[y, x, c] = weighted_mean(total, whole)


@cuda.jit
def mix_shifted_kernel(pictures, views, places, weights, mixed):
    x, y = cuda.grid(2)
    if y >= mixed.shape[0] or x >= mixed.shape[1]:
        return
    whole, first = np.int64(0), -1
    for k in range(places.shape[0]):
        if places[k, y, x] >= 0:
            whole += weights[k]
            if first < 0:
                first = k
    for c in range(mixed.shape[2]):
        if whole > 0:
            total = np.int64(0)
            for k in range(places.shape[0]):
                place = places[k, y, x]
                if place >= 0:
                    value = pictures[views[k], row_of(place), column_of(place), c]
                    total += weights[k] * np.int64(value)
            mixed[y, x, c] = weighted_mean(total, whole)
        else:
            k = max(first, 0)
            place = places[k, y, x]
            if place < 0:
                place = ~place
            mixed[y, x, c] = pictures[views[k], row_of(place), column_of(place), c]


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "interpolation: mix", mix_kernel, (PICTURES, NUMBERS, IMAGE)
    arguments = PICTURES, NUMBERS, LAYERS, NUMBERS, IMAGE
    yield "interpolation: mix shifted", mix_shifted_kernel, arguments


def mix(pictures, weights, mixed):
    """As :func:`stylit_ref.views.interpolation.passes.mix`."""
    launch(mix_kernel, mixed.shape[:2], pictures, weights, mixed)


def mix_shifted(pictures, views, places, weights, mixed):
    """As :func:`stylit_ref.views.interpolation.passes.mix_shifted`."""
    launch(mix_shifted_kernel, mixed.shape[:2], pictures, views, places, weights, mixed)
