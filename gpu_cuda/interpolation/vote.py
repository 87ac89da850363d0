"""Votes of the patches over each pixel."""

from functools import lru_cache

import numpy as np
from numba import cuda, types

from gpu_cuda.host.argument_types import INT, MAP, WORDS
from gpu_cuda.host.device import launch
from gpu_cuda.interpolation.formulae import column_of, row_of, weighted_mean

PIXELS = types.uint32[:, ::1]


@cuda.jit
def find_corners_kernel(nnf, stride, radius, corners):
    x, y = cuda.grid(2)
    if y < nnf.shape[0] and x < nnf.shape[1]:
        entry = nnf[y, x]
        corners[y, x] = (row_of(entry) - radius) * stride + column_of(entry) - radius


@lru_cache
def make_vote_kernel(width):
    """Compile the kernel for patches of a width."""
    radius = width // 2

    @cuda.jit
    def vote_views_kernel(corners, style, stride, picture, border):
        x, y = cuda.grid(2)
        height, columns = corners.shape
        if y >= height or x >= columns:
            return
        above, below = max(y - radius, 0), min(y + radius, height - 1)
        before, after = max(x - radius, 0), min(x + radius, columns - 1)
        count = (below - above + 1) * (after - before + 1)
        pixel = np.uint32(0)
        for shift in range(0, 32, 8):
            total = np.int64(0)
            for a in range(above, below + 1):
                for b in range(before, after + 1):
                    at = corners[a, b] + (radius + y - a) * stride + radius + x - b
                    total += (np.int64(style[at]) >> shift) & 0xFF
            pixel |= np.uint32(weighted_mean(total, count) << shift)
        picture[y + border, x + border] = pixel

    return vote_views_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "interpolation: corners", find_corners_kernel, (MAP, INT, INT, MAP)
    kernel = make_vote_kernel(sizes.patch_width)
    yield "interpolation: vote", kernel, (MAP, WORDS, INT, PIXELS, INT)


def find_corners(nnf, stride, radius, corners):
    """As :func:`stylit_ref.views.interpolation.passes.find_corners`."""
    launch(find_corners_kernel, nnf.shape, nnf, stride, radius, corners)


def make_vote(width):
    """As :func:`stylit_ref.views.interpolation.passes.make_vote`."""

    def vote(corners, style, stride, picture, border):
        kernel = make_vote_kernel(width)
        launch(kernel, corners.shape, corners, style, stride, picture, border)

    return vote
