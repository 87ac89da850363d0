"""Compile, launch and time kernels."""

from collections import defaultdict
from contextlib import contextmanager, nullcontext
from contextvars import ContextVar
from functools import lru_cache
from types import FunctionType

import numpy as np
from numba import config, cuda

SIMULATED = bool(config.ENABLE_CUDASIM)
"""Whether kernels run in Numba's simulator (``NUMBA_ENABLE_CUDASIM=1``), thread after thread."""

BLOCK = (8, 8) if SIMULATED else (32, 8)
"""Threads of a block along x and y."""


REGISTERS = 65536
"""Registers of a multiprocessor, 32 bits each, which all threads of a block share."""


def compiled_for(block):
    """Decorator that compiles a kernel for blocks of this size: it limits registers a thread.

    Without a limit a kernel of this package takes up to 166 registers. A block of 32 x 32 threads
    can only be launched with at most 64 registers each.
    """
    share = REGISTERS // (block[0] * block[1])
    return cuda.jit(max_registers=share) if share < 255 else cuda.jit


def formula(function):
    """Make a formula callable from a kernel.

    On a GPU, Numba compiles the ``@njit`` functions that a kernel calls. In the simulator a kernel
    is plain Python, and the simulator's array wrappers must be removed before the call.
    """
    if not SIMULATED:
        return function

    def call(*arguments):
        return function(*map(_undisguised, arguments))

    return call


def device_function(function):
    """Compile a function that uses shared memory, barriers or atomics, as only kernels can.

    The simulator replaces the function's ``cuda`` while one thread calls it, and restores it while
    other threads may still be inside. Here the function always finds the ``cuda`` of the kernel.
    """
    if not SIMULATED:
        return cuda.jit(device=True)(function)
    names = function.__globals__ | {"cuda": _RunningKernel()}
    return FunctionType(function.__code__, names, function.__name__, None, function.__closure__)


class _RunningKernel:
    """Stands for ``cuda`` in the simulator: that of the running kernel."""

    def __getattr__(self, name):
        from numba.cuda.simulator.kernel import _get_kernel_context

        return getattr(_get_kernel_context(), name)


def _undisguised(argument):
    if isinstance(argument, tuple):
        return tuple(map(_undisguised, argument))
    if isinstance(argument, np.generic):
        return argument
    array = getattr(argument, "_item", argument)  # those in tuples have one disguise less
    return getattr(array, "_ary", array)


def launch(kernel, size, *arguments, block=BLOCK, races=False):
    """Run a kernel with one thread for each pixel.

    Parameters
    ----------
    kernel : callable
        Compiled with ``cuda.jit``.
    size : (int, int)
        Rows and columns.
    *arguments
        Arguments of the kernel.
    block : (int, int)
        Threads of a block along x and y.
    races : bool
        Whether threads heed what others do meanwhile; the simulator then runs them side by side.
    """
    rows, columns = size
    grid = -(-columns // block[0]), -(-rows // block[1])
    with _timed(kernel), nullcontext() if races else _one_after_another():
        _configured(kernel, grid, block)(*arguments)


def launch_cooperative(kernel, most_threads, *arguments):
    """Run a kernel whose threads wait for each other.

    Parameters
    ----------
    kernel : callable
        Compiled with ``cuda.jit``; it must work with any number of threads.
    most_threads : int
        The number of threads that have something to do. Fewer are launched if the device cannot
        hold them all at once.
    *arguments
        Arguments of the kernel.
    """
    threads = BLOCK[0] * BLOCK[1]
    if SIMULATED:
        with _timed(kernel), _one_after_another():
            _configured(kernel, 1, min(threads, most_threads))(*arguments)
        return
    specialized = kernel.specialize(*arguments)
    blocks = min(-(-most_threads // threads), _blocks_at_once(specialized, threads))
    with _timed(kernel):
        _configured(specialized, blocks, threads)(*arguments)


def _one_after_another():
    if not SIMULATED:
        return nullcontext()
    from gpu_cuda.host.block_threads import one_after_another

    return one_after_another()


def _configured(kernel, grid, block):
    """A kernel for a grid of blocks, without Numba's warning that a coarse level has few blocks."""
    warned = config.CUDA_LOW_OCCUPANCY_WARNINGS
    config.CUDA_LOW_OCCUPANCY_WARNINGS = 0
    try:
        return kernel[grid, block]
    finally:
        config.CUDA_LOW_OCCUPANCY_WARNINGS = warned


@lru_cache
def _blocks_at_once(specialized, threads):
    (overload,) = specialized.overloads.values()
    return overload.max_cooperative_grid_blocks(threads)


_events = ContextVar("events around every launched kernel", default=None)


@contextmanager
def kernel_times():
    """Measure the device's time in every kernel that is launched in the block.

    Yields
    ------
    dict of str to list of float
        Seconds of every launch, by the name of the kernel's function. It is filled when the block
        ends; in the simulator all are 0.
    """
    seconds, events = defaultdict(list), []
    token = _events.set(events)
    try:
        yield seconds
        cuda.synchronize()
        for name, start, end in events:
            seconds[name].append(start.elapsed_time(end) / 1000 if not SIMULATED else 0.0)
    finally:
        _events.reset(token)


@contextmanager
def _timed(kernel):
    """Record an event before and after a launch, if :func:`kernel_times` is active."""
    events = _events.get()
    if events is None:
        yield
        return
    start, end = (cuda.event() for _ in range(2))
    start.record()
    yield
    end.record()
    function = kernel.fn if SIMULATED else kernel.py_func
    events.append((function.__name__, start, end))
