"""What a kernel needs of the machine: blocks, and formulae that it can call."""

from contextlib import suppress
from types import FunctionType

import numpy as np

with suppress(ImportError):  # numba-cuda's, where its .pth file went unread (pip --target)
    import _numba_cuda_redirector  # noqa: F401
from numba import config, cuda

config.CUDA_LOW_OCCUPANCY_WARNINGS = 0  # coarse levels are small, and that is no news

SIMULATED = bool(config.ENABLE_CUDASIM)
"""Whether kernels run in Numba's simulator (``NUMBA_ENABLE_CUDASIM=1``), thread after thread."""

BLOCK = (8, 8) if SIMULATED else (32, 8)
"""Threads of a block along x and y."""


REGISTERS = 65536
"""Of a multiprocessor, 32 bits each, for all threads of a block together."""


def compiled_for(block):
    """Decorator of a kernel whose blocks have as many threads: each gets its share of registers.

    Without a limit a kernel of this package takes up to 166, and a block of 32 x 32 threads with
    more than 64 each cannot be launched at all.
    """
    share = REGISTERS // (block[0] * block[1])
    return cuda.jit(max_registers=share) if share < 255 else cuda.jit


def formula(function):
    """Make a formula callable from a kernel.

    On a GPU a kernel compiles the ``@njit`` functions that it calls. In the simulator it is
    plain Python, and a formula must be given the arrays themselves, not their disguise.
    """
    if not SIMULATED:
        return function

    def call(*arguments):
        return function(*map(_undisguised, arguments))

    return call


def device_function(function):
    """Compile a function that reads, writes or waits as only kernels can.

    The simulator gives such a function its own ``cuda`` while it runs, and takes it away again
    while other threads may still be inside. Here it always finds that of the kernel that runs.
    """
    if not SIMULATED:
        return cuda.jit(device=True)(function)
    names = function.__globals__ | {"cuda": _RunningKernel()}
    return FunctionType(function.__code__, names, function.__name__, None, function.__closure__)


class _RunningKernel:
    """The simulator's ``cuda`` of the kernel that runs."""

    def __getattr__(self, name):
        from numba.cuda.simulator.kernel import _get_kernel_context

        return getattr(_get_kernel_context(), name)


def _undisguised(argument):
    if isinstance(argument, tuple):
        return tuple(map(_undisguised, argument))
    item = getattr(argument, "_item", None) if not isinstance(argument, np.generic) else None
    return item._ary if item is not None else argument


def launch(kernel, size, *arguments, block=BLOCK):
    """Run a kernel with one thread for each pixel.

    Parameters
    ----------
    kernel : callable
        Compiled with ``cuda.jit``.
    size : (int, int)
        Rows and columns.
    *arguments
        Of the kernel.
    block : (int, int)
        Threads of a block along x and y.
    """
    rows, columns = size
    grid = -(-columns // block[0]), -(-rows // block[1])
    kernel[grid, block](*arguments)


def launch_cooperative(kernel, *arguments):
    """Run a kernel whose threads wait for each other, with as many as the device holds at once."""
    threads = BLOCK[0] * BLOCK[1]
    if SIMULATED:
        kernel[1, threads](*arguments)
        return
    special = kernel.specialize(*arguments)
    (overload,) = special.overloads.values()
    special[overload.max_cooperative_grid_blocks(threads), threads](*arguments)
