"""Which vectors another field confirms."""

from numba import cuda

from gpu_cuda.host.device import launch
from gpu_cuda.views.argument_types import FIELD, FLAGS, PLACES
from gpu_cuda.views.formulae import fixed, is_consistent


@cuda.jit
def cancel_kernel(field, places, back, known, cancels):
    x, y = cuda.grid(2)
    if y >= places.shape[0] or x >= places.shape[1]:
        return
    row, column = places[y, x, 0], places[y, x, 1]
    cancels[y, x] = False
    if row >= 0 and known[row, column]:
        cancels[y, x] = is_consistent(
            fixed(field[y, x, 0]),
            fixed(field[y, x, 1]),
            fixed(back[row, column, 0]),
            fixed(back[row, column, 1]),
        )


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "views: cancel", cancel_kernel, (FIELD, PLACES, FIELD, FLAGS, FLAGS)


def cancel(field, places, back, known, cancels):
    """As :func:`stylit_ref.views.passes.cancel`."""
    launch(cancel_kernel, cancels.shape, field, places, back, known, cancels)
