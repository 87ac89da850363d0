"""The device's memory: images go there before a run, and the result comes back when it is done.

Between, each iteration reads back for the history how many pixels moved, and the energy of every
column.
"""

from contextlib import contextmanager

import numpy as np
from numba import cuda, types

from gpu_cuda.host.device import BLOCK, launch
from stylit_ref.errors import InputError

OUT_OF_MEMORY = 2
"""The driver's CUDA_ERROR_OUT_OF_MEMORY. The simulator has neither codes nor the class of error."""


@contextmanager
def _allocation(shape, dtype):
    """Say in one sentence that the device has no memory left."""
    try:
        yield
    except Exception as error:
        if getattr(error, "code", None) != OUT_OF_MEMORY:
            raise
        free, total = cuda.current_context().get_memory_info()
        needed = int(np.prod(shape)) * np.dtype(dtype).itemsize
        raise InputError(
            f"the GPU has {free >> 20} of {total >> 20} MiB free and needs {needed >> 20} more for "
            "these images; take smaller ones, or --backend cpu"
        ) from None


def empty(shape, dtype):
    """Array of the device whose contents are undefined."""
    with _allocation(shape, dtype):
        return cuda.device_array(shape, dtype)


def upload(array):
    """As :func:`stylit_ref.passes.upload`: a copy in the device's memory."""
    array = np.ascontiguousarray(array)
    with _allocation(array.shape, array.dtype):
        return cuda.to_device(array)


def download(array):
    """As :func:`stylit_ref.passes.download`."""
    return array.copy_to_host()


def wait():
    """As :func:`stylit_ref.passes.wait`: kernels run on when their launch has returned."""
    cuda.synchronize()


def zeros(shape, dtype):
    """As :func:`stylit_ref.passes.zeros`, in the device's memory."""
    array = empty(shape, dtype)
    fill(array, 0)
    return array


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "fill", fill_kernel, (types.int32[::1], types.int64)


@cuda.jit
def fill_kernel(values, value):
    """Write the same value everywhere."""
    place = cuda.grid(1)
    if place < values.size:
        values[place] = value


def fill(array, value):
    """Write the same value everywhere in an array of the device."""
    launch(
        fill_kernel,
        (1, array.size),
        array.reshape(array.size),
        value,
        block=(BLOCK[0] * BLOCK[1], 1),
    )
