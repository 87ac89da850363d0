"""Which labels there are, and those of the entries."""

from numba import cuda, types

from gpu_cuda.host.argument_types import INT
from gpu_cuda.host.device import launch
from stylit_ref.realtime.passes.search import FREE

LABELS, ENTRIES, THERE = types.uint8[:, ::1], types.int16[:, ::1], types.boolean[::1]


@cuda.jit
def mark_labels_kernel(labels, is_there):
    x, y = cuda.grid(2)
    if y < labels.shape[0] and x < labels.shape[1]:
        is_there[labels[y, x]] = True


@cuda.jit
def decimate_labels_kernel(labels, level, step, out):
    b, a = cuda.grid(2)
    if a < out.shape[0] and b < out.shape[1]:
        out[a, b] = labels[(a * step) << level, (b * step) << level]


@cuda.jit
def free_lost_labels_kernel(labels, is_there):
    b, a = cuda.grid(2)
    if a < labels.shape[0] and b < labels.shape[1] and not is_there[labels[a, b]]:
        labels[a, b] = FREE


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "realtime: mark labels", mark_labels_kernel, (LABELS, THERE)
    yield "realtime: decimate labels", decimate_labels_kernel, (LABELS, INT, INT, ENTRIES)
    yield "realtime: free lost labels", free_lost_labels_kernel, (ENTRIES, THERE)


def mark_labels(labels, is_there):
    """As :func:`stylit_ref.realtime.passes.mark_labels`."""
    launch(mark_labels_kernel, labels.shape, labels, is_there)


def decimate_labels(labels, level, step, out):
    """As :func:`stylit_ref.realtime.passes.decimate_labels`."""
    launch(decimate_labels_kernel, out.shape, labels, level, step, out)


def free_lost_labels(labels, is_there):
    """As :func:`stylit_ref.realtime.passes.free_lost_labels`."""
    launch(free_lost_labels_kernel, labels.shape, labels, is_there)
