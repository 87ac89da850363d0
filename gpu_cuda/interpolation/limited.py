"""The limited search among the shifted NNFs."""

from functools import lru_cache

import numpy as np
from numba import cuda

from gpu_cuda.host.argument_types import MAP
from gpu_cuda.host.device import launch
from gpu_cuda.interpolation.formulae import column_of, row_of
from gpu_cuda.interpolation.shift import LAYERS
from gpu_cuda.realtime.image import IMAGE
from gpu_cuda.realtime.search import WEIGHTS, make_energy
from stylit_ref.machine.vector_patch import STYLE_LANES


@lru_cache
def make_limited_kernel(width):
    """Compile the kernel for patches of a width."""
    energy, radius = make_energy(width, width, STYLE_LANES), width // 2

    @cuda.jit
    def limited_search_kernel(nnf, candidates, style, picture, weights, found):
        x, y = cuda.grid(2)
        if y >= nnf.shape[0] or x >= nnf.shape[1]:
            return
        origin = (style.border - radius) * (style.stride + 1)
        target = (picture.border - radius) * (picture.stride + 1) + y * picture.stride + x
        best, best_entry = np.int64(-1), nnf[y, x]
        for k in range(-1, candidates.shape[0]):
            entry = nnf[y, x] if k < 0 else candidates[k, y, x]
            if entry < 0 or (k >= 0 and entry == best_entry):
                continue
            error = np.int64(
                energy(
                    style.values,
                    (origin + row_of(entry) * style.stride + column_of(entry)) * STYLE_LANES,
                    style.stride, picture.values, target * STYLE_LANES, picture.values,
                    target * STYLE_LANES, picture.stride, weights,
                )
            )  # fmt: skip
            if best < 0 or error < best:
                best, best_entry = error, entry
        found[y, x] = best_entry

    return limited_search_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    kernel = make_limited_kernel(sizes.patch_width)
    yield "interpolation: limited search", kernel, (MAP, LAYERS, IMAGE, IMAGE, WEIGHTS, MAP)


def make_limited_search(width):
    """As :func:`stylit_ref.views.interpolation.passes.make_limited_search`."""

    def limited_search(nnf, candidates, style, picture, weights, found):
        kernel = make_limited_kernel(width)
        launch(kernel, nnf.shape, nnf, candidates, style, picture, weights, found)

    return limited_search
