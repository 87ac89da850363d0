"""What a kernel needs of the machine: blocks, and formulae that it can call."""

from collections import defaultdict
from contextlib import contextmanager
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
    with _timed(kernel):
        _configured(kernel, grid, block)(*arguments)


def launch_cooperative(kernel, most_threads, *arguments):
    """Run a kernel whose threads wait for each other.

    Parameters
    ----------
    kernel : callable
        Compiled with ``cuda.jit``; for as many threads as there are.
    most_threads : int
        As many as have something to do; fewer run where the device does not hold them at once.
    *arguments
        Of the kernel.
    """
    threads = BLOCK[0] * BLOCK[1]
    if SIMULATED:
        with _timed(kernel):
            _configured(kernel, 1, min(threads, most_threads))(*arguments)
        return
    specialized = kernel.specialize(*arguments)
    blocks = min(-(-most_threads // threads), _blocks_at_once(specialized, threads))
    with _timed(kernel):
        _configured(specialized, blocks, threads)(*arguments)


def _configured(kernel, grid, block):
    """A kernel for a grid of blocks: coarse levels have few, and Numba's warning is no news."""
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
    """Measure what the device spends in every kernel that is launched inside.

    Yields
    ------
    dict of str to list of float
        Seconds of every launch, by the kernel's function; filled when the context ends. In the
        simulator they are 0.
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
    """Between two events, where someone wants to know: nothing waits."""
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
