"""A pyramid level of the host on the device."""

from copy import copy

from numba import cuda

import gpu_cuda
from gpu_cuda.host.device import SIMULATED

FULL_SIZES = (
    []
    if SIMULATED
    else [
        {"source_size": size, "target_size": size, "guide_channels": (3,) * 5, "smooth": True}
        for size in ((228, 300), (912, 1200))
    ]
)
"""Cases of :func:`small_level.make_level` that are too large for the simulator."""

HOST_ALONE = "pair_weights", "moment_weights", "style_pair_weights"
ARRAYS = ("nnf", "delta", "proposed_nnf", "proposed_delta", "omega", "omega_sums", "moves")


def on_device(level):
    """The same level with its arrays on the device and CUDA's passes."""
    twin = copy(level)
    twin.passes = gpu_cuda
    twin.textures = level.textures._replace(
        **{
            name: cuda.to_device(array)
            for name, array in level.textures._asdict().items()
            if array is not None and name not in HOST_ALONE
        }
    )
    for name in ARRAYS:
        setattr(twin, name, cuda.to_device(getattr(level, name)))
    return twin


def to_host(array):
    """A device array's contents."""
    return array.copy_to_host()
