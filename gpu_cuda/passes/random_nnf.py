"""Random initial assignments (Kernel_RandomNNF, thesis 3.4).

Kernel_InitRandom has no counterpart: random numbers are counted, not carried
(:mod:`stylit_ref.randomness.random_stream`).
"""

from numba import cuda

from gpu_cuda.formulae import random_words, uniform_below
from gpu_cuda.host.argument_types import INT, NNF, STREAM
from gpu_cuda.host.device import launch


@cuda.jit
def random_nnf_kernel(nnf, radius, source_height, source_width, stream):
    x, y = cuda.grid(2)
    if y >= nnf.shape[0] or x >= nnf.shape[1] or nnf[y, x, 0] < 0:
        return
    words = random_words(stream, y * nnf.shape[1] + x, 0)
    nnf[y, x, 0] = radius + uniform_below(words[0], source_height - 2 * radius)
    nnf[y, x, 1] = radius + uniform_below(words[1], source_width - 2 * radius)


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "random NNF", random_nnf_kernel, (NNF, INT, INT, INT, STREAM)


def random_nnf(nnf, patch_width, source_height, source_width, stream):
    """As :func:`stylit_ref.passes.random_nnf`, on device arrays."""
    arguments = nnf, patch_width // 2, source_height, source_width, stream
    launch(random_nnf_kernel, nnf.shape[:2], *arguments)
