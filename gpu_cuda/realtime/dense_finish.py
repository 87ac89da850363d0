"""A match for every pixel, and a vote of all of them: a thread for each pixel."""

from functools import lru_cache

import numpy as np
from numba import cuda

from gpu_cuda.host.argument_types import IMAGE as PICTURE
from gpu_cuda.host.argument_types import INT, MAP
from gpu_cuda.host.device import launch
from gpu_cuda.realtime.formulae import (
    column_of,
    covering_entries,
    first_centre,
    last_centre,
    mean_of,
    packed,
    row_of,
)
from gpu_cuda.realtime.image import BYTES, IMAGE
from gpu_cuda.realtime.labels import LABELS
from gpu_cuda.realtime.search import WEIGHTS, make_energy
from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.realtime.passes.search import WORST


@lru_cache
def make_dense_kernel(width, step, lanes):
    """Compile the kernel for patches of a width, entries ``step`` apart and pixels of lanes."""
    energy, radius = make_energy(width, width, lanes), width // 2

    @cuda.jit
    def dense_nnf_kernel(nnf, source, guides, style, weights, labels, source_labels, out, stop):
        x, y = cuda.grid(2)
        if y >= out.shape[0] or x >= out.shape[1] or stop[0]:
            return
        first_y, last_y = first_centre(source.height, radius), last_centre(source.height, radius)
        first_x, last_x = first_centre(source.width, radius), last_centre(source.width, radius)
        origin = (source.border - radius) * (source.stride + 1)
        target = (style.border - radius) * (style.stride + 1) + y * style.stride + x
        top, bottom = covering_entries(y, step, radius, nnf.shape[0])
        left, right = covering_entries(x, step, radius, nnf.shape[1])
        best, best_y, best_x = np.int64(-1), np.int64(0), np.int64(0)
        for a in range(top, bottom + 1):
            for b in range(left, right + 1):
                new_y = min(max(row_of(nnf[a, b]) + y - a * step, first_y), last_y)
                new_x = min(max(column_of(nnf[a, b]) + x - b * step, first_x), last_x)
                forbidden = labels.size > 0 and source_labels[new_y, new_x] != labels[y, x]
                if best >= 0 and forbidden:
                    continue
                if forbidden:
                    found = np.int64(WORST)
                else:
                    found = np.int64(
                        energy(
                            source.values, (origin + new_y * source.stride + new_x) * lanes,
                            source.stride, guides.values, target * lanes, style.values,
                            target * STYLE_LANES, style.stride, weights,
                        )
                    )  # fmt: skip
                if best < 0 or found < best:
                    best, best_y, best_x = found, new_y, new_x
        out[y, x] = packed(best_y, best_x)

    return dense_nnf_kernel


@cuda.jit
def vote_kernel(nnf, style, out, radius, stop):
    x, y = cuda.grid(2)
    height, width = nnf.shape
    if y >= height or x >= width or stop[0]:
        return
    above, below = max(y - radius, 0), min(y + radius, height - 1)
    before, after = max(x - radius, 0), min(x + radius, width - 1)
    count = (below - above + 1) * (after - before + 1)
    for c in range(3):
        total = np.uint32(0)
        for a in range(above, below + 1):
            for b in range(before, after + 1):
                from_y = row_of(nnf[a, b]) + y - a + style.border
                from_x = column_of(nnf[a, b]) + x - b + style.border
                at = (from_y * style.stride + from_x) * STYLE_LANES + c
                total += np.uint32(style.values[at])
        out[y, x, c] = mean_of(total, count)


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    arguments = MAP, IMAGE, IMAGE, IMAGE, WEIGHTS, LABELS, LABELS, MAP, BYTES
    yield "realtime: dense matches", make_dense_kernel(5, 3, 16), arguments
    yield "realtime: vote", vote_kernel, (MAP, IMAGE, PICTURE, INT, BYTES)


def make_dense_nnf(width, step, lanes):
    """As :func:`stylit_ref.realtime.passes.make_dense_nnf`."""
    kernel = make_dense_kernel(width, step, lanes)

    def dense_nnf(nnf, source, guides, style, weights, labels, source_labels, out, stop):
        launch(
            kernel, out.shape, nnf, source, guides, style, weights, labels, source_labels, out, stop
        )  # fmt: skip

    return dense_nnf


def make_vote(width):
    """As :func:`stylit_ref.realtime.passes.make_vote`."""

    def vote(nnf, style, out, stop):
        launch(vote_kernel, nnf.shape, nnf, style, out, width // 2, stop)

    return vote
