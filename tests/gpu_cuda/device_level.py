"""A pyramid level of the host on the device."""

from copy import copy

from numba import cuda

import gpu_cuda

ARRAYS = ("nnf", "delta", "proposed_nnf", "proposed_delta", "omega", "omega_sums")


def on_device(level):
    """The same level with its arrays on the device and CUDA's passes."""
    twin = copy(level)
    twin.passes = gpu_cuda
    twin.textures = type(level.textures)(
        *(None if array is None else cuda.to_device(array) for array in level.textures)
    )
    for name in ARRAYS:
        setattr(twin, name, cuda.to_device(getattr(level, name)))
    return twin


def to_host(array):
    """A device array's contents."""
    return array.copy_to_host()
