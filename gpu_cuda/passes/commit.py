"""Commit: proposals become assignments while Ω follows (the canonical schedule).

The 16 classes take 33 small steps, each of which needs the whole result of the one before. As
separate kernels they would take longer to launch than to run. So one cooperative kernel does all
of them: its threads stay on the device and wait for each other between the steps (a grid-wide
barrier). W is updated by atomic additions of integers, whose order does not matter.
"""

from functools import lru_cache

import numpy as np
from numba import cuda

from gpu_cuda.formulae import commit_order, take_proposal, update_omega_sums
from gpu_cuda.host.argument_types import COMMITMENT, NUMBERS, STREAM
from gpu_cuda.host.device import device_function, launch_cooperative
from stylit_ref.randomness.commit_classes import CLASS_STRIDE

CLASSES = CLASS_STRIDE**2


@device_function
def class_size(size, first):
    """Number of rows (or columns) of the class that begins at row (or column) ``first``."""
    return (size - first + CLASS_STRIDE - 1) // CLASS_STRIDE


@device_function
def follow(nnf, proposed_nnf, omega_sums, patch_width, y, x):
    """Update W for a pixel that moved."""
    new_y, new_x = nnf[y, x, 0], nnf[y, x, 1]
    old_y, old_x = proposed_nnf[y, x, 0], proposed_nnf[y, x, 1]
    if old_y != new_y or old_x != new_x:
        update_omega_sums(omega_sums, patch_width, new_y, new_x, 1)
        update_omega_sums(omega_sums, patch_width, old_y, old_x, -1)


@lru_cache
def make_kernel(patch_width):
    """Compile the cooperative kernel for a patch width."""

    @cuda.jit
    def commit_kernel(
        nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight, stream, moves
    ):
        grid = cuda.cg.this_grid()
        order = cuda.local.array((CLASSES, 2), np.int32)
        commit_order(stream, order)
        height, width = delta.shape
        thread, threads = cuda.grid(1), cuda.gridsize(1)
        moved = 0
        for n in range(CLASSES):
            first_y, first_x = order[n, 0], order[n, 1]
            columns = class_size(width, first_x)
            pixels = class_size(height, first_y) * columns
            for k in range(thread, pixels, threads):
                y = first_y + CLASS_STRIDE * (k // columns)
                x = first_x + CLASS_STRIDE * (k % columns)
                moved += take_proposal(
                    nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight, y, x
                )
            if occurrence_weight:
                grid.sync()
                for k in range(thread, pixels, threads):
                    y = first_y + CLASS_STRIDE * (k // columns)
                    x = first_x + CLASS_STRIDE * (k % columns)
                    follow(nnf, proposed_nnf, omega_sums, patch_width, y, x)
                grid.sync()
        if moved:
            cuda.atomic.add(moves, 0, moved)

    return commit_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "commit", make_kernel(sizes.patch_width), (*COMMITMENT, STREAM, NUMBERS)


def commit(
    nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight, patch_width, stream,
    moves,
):  # fmt: skip
    """As :func:`stylit_ref.passes.commit`, on device arrays."""
    rows, columns = (-(-side // CLASS_STRIDE) for side in delta.shape)
    launch_cooperative(
        make_kernel(patch_width), rows * columns,
        nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight, stream, moves,
    )  # fmt: skip
