"""Fold the shifted pictures of the neighbours into this frame's B'."""

import numpy as np
from numba import cuda, types

from gpu_cuda.host.argument_types import IMAGE, NUMBERS
from gpu_cuda.host.device import launch
from gpu_cuda.views.formulae import folded, spread
from stylit_ref.views.formulae.fold import ONE

GUIDES = types.uint8[:, :, :, ::1]


@cuda.jit
def fold_kernel(own, guides, weights, mixed, spreads):
    x, y = cuda.grid(2)
    if y >= own.shape[0] or x >= own.shape[1]:
        return
    everything = np.int64(ONE)
    for k in range(guides.shape[0]):
        everything += weights[k]
    deviation = np.int64(0)
    for c in range(own.shape[2]):
        value = np.int64(own[y, x, c])
        total, squares = ONE * value, ONE * value * value
        for k in range(guides.shape[0]):
            value = np.int64(guides[k, y, x, c])
            total += weights[k] * value
            squares += weights[k] * value * value
        mixed[y, x, c] = folded(total, everything)
        deviation += everything * squares - total * total
    spreads[y, x, 0] = spread(deviation, everything)


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "views: fold", fold_kernel, (IMAGE, GUIDES, NUMBERS, IMAGE, IMAGE)


def fold(own, guides, weights, mixed, spreads):
    """As :func:`stylit_ref.views.passes.fold`."""
    launch(fold_kernel, own.shape[:2], own, guides, weights, mixed, spreads)
