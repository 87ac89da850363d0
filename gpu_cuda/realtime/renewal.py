"""Matches of a coarse level where old ones are too old: a thread for each block of entries."""

from functools import lru_cache

import numpy as np
from numba import cuda, njit

from gpu_cuda.host.argument_types import INT, MAP
from gpu_cuda.host.device import formula, launch
from gpu_cuda.realtime.formulae import (
    coarse,
    column_of,
    fine,
    first_centre,
    is_old,
    last_centre,
    packed,
    row_of,
)
from gpu_cuda.realtime.image import IMAGE
from gpu_cuda.realtime.search import GRID, WEIGHTS, make_energy
from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.realtime.passes.search import FREE


@formula
@njit
def _label_at(labels, a, b):
    return np.int64(labels[a, b]) if labels.size else np.int64(FREE)


@formula
@njit
def _is_allowed(label, source_labels, y, x):
    return label == FREE or source_labels[y, x] == label


@lru_cache
def make_kernel(rows, pixels, lanes):
    """Compile the kernel for patches of a shape; records are patches of one row."""
    energy = make_energy(rows, pixels, lanes)
    reach = rows // 2
    width_of = 1 if rows > 1 else pixels  # pixels of the images' memory that are one of theirs

    @cuda.jit
    def renewal_kernel(
        nnf, fresh, level, source, guides, style, weights, grid, height, width, fine_grid
    ):
        b, a = cuda.grid(2)
        if a >= fresh.shape[0] or b >= fresh.shape[1]:
            return
        step, margin = grid.step, grid.margin
        target = (style.border - reach) * (style.stride + 1)
        target += (a * style.stride + b) * grid.spacing
        guide_at, style_at = target * lanes * width_of, target * STYLE_LANES * width_of
        origin = (source.border - reach) * (source.stride + 1)
        entry = nnf[a << level, b << level]
        own_y = min(
            max(coarse(row_of(entry), level), first_centre(source.height, margin)),
            last_centre(source.height, margin),
        )
        own_x = min(
            max(coarse(column_of(entry), level), first_centre(source.width, margin)),
            last_centre(source.width, margin),
        )
        y, x = row_of(fresh[a, b]), column_of(fresh[a, b])
        own = energy(
            source.values, (origin + own_y * source.stride + own_x) * lanes * width_of,
            source.stride, guides.values, guide_at, style.values, style_at, style.stride, weights,
        )  # fmt: skip
        new = energy(
            source.values, (origin + y * source.stride + x) * lanes * width_of,
            source.stride, guides.values, guide_at, style.values, style_at, style.stride, weights,
        )  # fmt: skip
        label = _label_at(grid.labels, a, b)
        old = is_old(np.int64(own), np.int64(new)) or not _is_allowed(
            label, grid.source_labels, own_y, own_x
        )
        labels = fine_grid.source_labels
        for i in range(a << level, min((a + 1) << level, nnf.shape[0])):
            for j in range(b << level, min((b + 1) << level, nnf.shape[1])):
                entry = nnf[i, j]
                label = _label_at(fine_grid.labels, i, j)
                if not old and _is_allowed(label, labels, row_of(entry), column_of(entry)):
                    continue
                new_y = min(
                    max(fine(y, level, step, i, a), first_centre(height, margin)),
                    last_centre(height, margin),
                )
                new_x = min(
                    max(fine(x, level, step, j, b), first_centre(width, margin)),
                    last_centre(width, margin),
                )
                if _is_allowed(label, labels, new_y, new_x):
                    nnf[i, j] = packed(new_y, new_x)

    return renewal_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    arguments = MAP, MAP, INT, IMAGE, IMAGE, IMAGE, WEIGHTS, GRID, INT, INT, GRID
    yield "realtime: renewal", make_kernel(5, 5, 16), arguments


def make_renew(rows, pixels, lanes):
    """As :func:`stylit_ref.realtime.passes.make_renew`."""
    kernel = make_kernel(rows, pixels, lanes)

    def renew(nnf, fresh, level, source, guides, style, weights, grid, height, width, fine_grid):
        launch(
            kernel, fresh.shape, nnf, fresh, level, source, guides, style, weights, grid, height,
            width, fine_grid,
        )  # fmt: skip

    return renew
