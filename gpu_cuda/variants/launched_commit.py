"""The passes with a launch for every step of a commit: measures what one cooperative kernel saves.

The results are the same.
"""

from functools import lru_cache

import numpy as np
from numba import cuda

import gpu_cuda
from gpu_cuda.formulae import take_proposal
from gpu_cuda.host.argument_types import COMMITMENT, INT, MAP, NNF, NUMBERS
from gpu_cuda.host.device import launch
from gpu_cuda.passes.commit import CLASSES, class_size, follow
from stylit_ref.machine.replaced import replaced
from stylit_ref.randomness.commit_classes import CLASS_STRIDE, commit_order


@cuda.jit
def decide_kernel(
    nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight,
    first_y, first_x, moves,
):  # fmt: skip
    column, row = cuda.grid(2)
    height, width = delta.shape
    if row < class_size(height, first_y) and column < class_size(width, first_x):
        y, x = first_y + CLASS_STRIDE * row, first_x + CLASS_STRIDE * column
        if take_proposal(
            nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight, y, x
        ):
            cuda.atomic.add(moves, 0, 1)


@lru_cache
def make_follow_kernel(patch_width):
    """Compile the step that updates W."""

    @cuda.jit
    def follow_kernel(nnf, proposed_nnf, omega_sums, first_y, first_x):
        column, row = cuda.grid(2)
        height, width = nnf.shape[0], nnf.shape[1]
        if row < class_size(height, first_y) and column < class_size(width, first_x):
            y, x = first_y + CLASS_STRIDE * row, first_x + CLASS_STRIDE * column
            follow(nnf, proposed_nnf, omega_sums, patch_width, y, x)

    return follow_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "launched commit, decide", decide_kernel, (*COMMITMENT, INT, INT, NUMBERS)
    follow_kernel = make_follow_kernel(sizes.patch_width)
    yield "launched commit, follow", follow_kernel, (NNF, NNF, MAP, INT, INT)


def commit(
    nnf, delta, proposed_nnf, proposed_delta, omega_sums, occurrence_weight, patch_width, stream,
    moves,
):  # fmt: skip
    """As :func:`gpu_cuda.commit`."""
    order = np.empty((CLASSES, 2), np.int32)
    commit_order(stream, order)
    follow_kernel = make_follow_kernel(patch_width)
    for first_y, first_x in order.tolist():
        size = [-(-side // CLASS_STRIDE) for side in delta.shape]
        launch(
            decide_kernel, size, nnf, delta, proposed_nnf, proposed_delta, omega_sums,
            occurrence_weight, first_y, first_x, moves,
        )  # fmt: skip
        if occurrence_weight:
            launch(follow_kernel, size, nnf, proposed_nnf, omega_sums, first_y, first_x)


passes = replaced(gpu_cuda, commit=commit)
"""All passes; the commit launches a kernel for each of its steps."""
