"""The device's memory: images are copied there before a run, and the result back after it.

During the run only the history is read back: after each iteration the number of pixels that
moved, and the energy of every column.
"""

from contextlib import contextmanager

import numpy as np
from numba import cuda, types

from gpu_cuda.host.device import BLOCK, launch
from stylit_ref.errors import InputError

OUT_OF_MEMORY = 2
"""The driver's code CUDA_ERROR_OUT_OF_MEMORY; the simulator has neither codes nor that error."""


@contextmanager
def _allocation(shape, dtype):
    """Turn the driver's error into one sentence when the device has no memory left."""
    try:
        yield
    except Exception as error:
        if getattr(error, "code", None) != OUT_OF_MEMORY:
            raise
        free, total = cuda.current_context().get_memory_info()
        needed = int(np.prod(shape)) * np.dtype(dtype).itemsize
        raise InputError(
            f"the GPU has {free >> 20} of {total >> 20} MiB free, but these images need "
            f"{needed >> 20} MiB more; use smaller images, or --backend cpu"
        ) from None


def empty(shape, dtype):
    """An array on the device with undefined contents."""
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
    """As :func:`stylit_ref.passes.wait`: a launch returns before its kernel has finished."""
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
    """Fill an array on the device with a value."""
    launch(
        fill_kernel,
        (1, array.size),
        array.reshape(array.size),
        value,
        block=(BLOCK[0] * BLOCK[1], 1),
    )
