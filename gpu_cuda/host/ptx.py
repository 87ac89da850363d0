"""Compile every kernel to PTX without a device.

This shows what the simulator cannot: type errors and, with ``ptxas``, registers, shared memory
and spills.
"""

import pkgutil
from types import SimpleNamespace
from unittest import mock

from numba import cuda, types

import gpu_cuda
from gpu_cuda.host.argument_types import Sizes

CAPABILITIES = ((7, 5), (9, 0))
BLOCKS = (32, 8), (32, 32)
"""Threads of a block along x and y: the default, and the thesis' (4.1)."""


def kernels(block):
    """Name, kernel and argument types of every kernel, at the thesis' sizes.

    Parameters
    ----------
    block : (int, int)
        Threads of a block along x and y.
    """
    for module in pkgutil.walk_packages(gpu_cuda.__path__, "gpu_cuda."):
        in_module = getattr(pkgutil.resolve_name(module.name), "kernels", None)
        if in_module and module.name != __name__:
            yield from in_module(Sizes(block))


def compile_to_ptx(kernel, arguments, capability):
    """Compile a kernel to PTX for a compute capability; no device is needed."""
    # Numba compiles the functions that a kernel calls for the current device, so pretend to one.
    device = SimpleNamespace(compute_capability=capability)
    with mock.patch("numba.cuda.dispatcher.get_current_device", return_value=device):
        ptx, _ = cuda.compile(
            kernel.py_func, types.void(*arguments), cc=capability, device=False, abi="numba"
        )
    return ptx
