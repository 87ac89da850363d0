"""A half iteration of the search: a thread for every other entry, whose neighbours stay."""

from functools import lru_cache

import numpy as np
from numba import cuda, njit, types

from gpu_cuda.host.argument_types import INT, MAP, STREAM
from gpu_cuda.host.device import formula, launch
from gpu_cuda.realtime.formulae import (
    column_of,
    first_centre,
    last_centre,
    packed,
    random_column,
    random_row,
    random_words,
    row_of,
)
from gpu_cuda.realtime.image import BYTES, IMAGE
from gpu_cuda.realtime.labels import ENTRIES, LABELS
from gpu_cuda.realtime.moving import MOVING
from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.realtime.passes.search import DOWN, FREE, RIGHT, WORST, Grid

GRID = types.NamedTuple((INT, INT, INT, ENTRIES, LABELS, MOVING), Grid)
WEIGHTS = types.int16[::1]


@lru_cache
def make_energy(rows, pixels, lanes):
    """The weighted sum of squared differences of two patches, the second in two images."""
    own = lanes - STYLE_LANES

    @njit
    def energy(source, at, stride, guides, guide_at, style, style_at, target_stride, weights):
        total = np.int32(0)
        for _ in range(rows):
            for pixel in range(pixels):
                for c in range(lanes):
                    if c < own:
                        wanted = guides[guide_at + pixel * lanes + c]
                    else:
                        wanted = style[style_at + pixel * STYLE_LANES + c - own]
                    found = source[at + pixel * lanes + c]
                    difference = np.int32(found) - np.int32(wanted)
                    weight = np.int32(weights[pixel * lanes + c])
                    total = np.int32(total + weight * difference * difference)
            at += stride * lanes
            guide_at += target_stride * lanes
            style_at += target_stride * STYLE_LANES
        return total

    return formula(energy)


@lru_cache
def make_kernel(rows, pixels, lanes):
    """Compile the kernel for patches of a shape; records are patches of one row."""
    energy = make_energy(rows, pixels, lanes)
    reach = rows // 2
    width_of = 1 if rows > 1 else pixels  # pixels of the images' memory that are one of theirs

    @cuda.jit
    def half_search_kernel(
        nnf, source, guides, style, weights, grid, stream, parity, largest_radius, stop
    ):
        k, a = cuda.grid(2)
        height, width = nnf.shape
        b = ((a + parity) & 1) + 2 * k
        if a >= height or b >= width or stop[0]:
            return
        if grid.moving.size and not grid.moving[a, b]:
            return
        step, labels, source_labels = grid.step, grid.labels, grid.source_labels
        first_y = first_centre(source.height, grid.margin)
        last_y = last_centre(source.height, grid.margin)
        first_x = first_centre(source.width, grid.margin)
        last_x = last_centre(source.width, grid.margin)
        origin = (source.border - reach) * (source.stride + 1)
        target = (style.border - reach) * (style.stride + 1)
        target += (a * style.stride + b) * grid.spacing
        guide_at, style_at = target * lanes * width_of, target * STYLE_LANES * width_of
        label = np.int64(labels[a, b]) if labels.size else np.int64(FREE)
        y, x = row_of(nnf[a, b]), column_of(nnf[a, b])
        if label != FREE and source_labels[y, x] != label:
            best = np.int32(WORST)
        else:
            at = (origin + y * source.stride + x) * lanes * width_of
            best = energy(
                source.values, at, source.stride, guides.values, guide_at, style.values, style_at,
                style.stride, weights,
            )  # fmt: skip
        middle_y, middle_x = y, x
        trial = 0
        while trial < 4 or largest_radius >> (trial - 4) > 0:
            if trial < 4:
                na, nb = a + DOWN[trial], b + RIGHT[trial]
                if na < 0 or na >= height or nb < 0 or nb >= width:
                    trial += 1
                    continue
                entry = nnf[na, nb]
                new_y = min(max(row_of(entry) + (a - na) * step, first_y), last_y)
                new_x = min(max(column_of(entry) + (b - nb) * step, first_x), last_x)
            else:
                if trial == 4:
                    middle_y, middle_x = y, x
                radius = largest_radius >> (trial - 4)
                words = random_words(stream, a * width + b, (trial - 4) // 4)
                word = words[trial % 4]
                new_y = random_row(
                    word, max(middle_y - radius, first_y), min(middle_y + radius, last_y)
                )
                new_x = random_column(
                    word, max(middle_x - radius, first_x), min(middle_x + radius, last_x)
                )
            trial += 1
            if new_y == y and new_x == x:
                continue
            if label != FREE and source_labels[new_y, new_x] != label:
                continue
            at = (origin + new_y * source.stride + new_x) * lanes * width_of
            found = energy(
                source.values, at, source.stride, guides.values, guide_at, style.values, style_at,
                style.stride, weights,
            )  # fmt: skip
            if found < best:
                best, y, x = found, new_y, new_x
        nnf[a, b] = packed(y, x)

    return half_search_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    arguments = MAP, IMAGE, IMAGE, IMAGE, WEIGHTS, GRID, STREAM, INT, INT, BYTES
    for name, shape in (
        ("patches of guides and style", (5, 5, 16)),
        ("patches of style", (5, 5, STYLE_LANES)),
        ("records", (1, 3, 16)),
    ):
        yield f"realtime: search of {name}", make_kernel(*shape), arguments


def make_search(rows, pixels, lanes):
    """As :func:`stylit_ref.realtime.passes.make_search`."""
    kernel = make_kernel(rows, pixels, lanes)

    def search(
        nnf, source, guides, style, weights, grid, stream, parity, largest_radius, stop
    ):  # fmt: skip
        height, width = nnf.shape
        launch(
            kernel, (height, (width + 1) // 2), nnf, source, guides, style, weights, grid, stream,
            parity, largest_radius, stop,
        )  # fmt: skip

    return search
