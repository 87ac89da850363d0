"""The passes with the target patches of a block in shared memory (thesis 5.1).

The results are those of the plain kernels, byte for byte.
"""

import gpu_cuda
from gpu_cuda.metric import launch_search
from gpu_cuda.propagation import make_kernel as make_propagation_kernel
from gpu_cuda.random_search import make_kernel as make_random_search_kernel
from stylit_ref.formulae.search_radii import number_of_radii

__all__ = gpu_cuda.__all__


def __getattr__(name):
    """The other passes are the plain ones."""
    return getattr(gpu_cuda, name)


def propagation(
    textures, omega_sums, occurrence_weight, patch_width,
    nnf, delta, new_nnf, new_delta, distance,
):  # fmt: skip
    """As :func:`gpu_cuda.propagation`."""
    launch_search(
        make_propagation_kernel, textures, omega_sums, occurrence_weight, patch_width,
        nnf, delta, new_nnf, new_delta, distance, shared=True,
    )  # fmt: skip


def random_search(
    textures, omega_sums, occurrence_weight, patch_width,
    nnf, delta, new_nnf, new_delta, stream, side=None,
):  # fmt: skip
    """As :func:`gpu_cuda.random_search`."""
    launch_search(
        make_random_search_kernel, textures, omega_sums, occurrence_weight, patch_width,
        nnf, delta, new_nnf, new_delta, stream, number_of_radii(side or max(delta.shape)),
        shared=True,
    )  # fmt: skip
