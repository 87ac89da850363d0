"""Types of the arguments of kernels, and the sizes to compile a kernel for without a device.

Every module with kernels has a function ``kernels(sizes)``, which yields the name, the function
and the argument types of each kernel (:mod:`gpu_cuda.host.ptx` compiles them).
"""

from typing import NamedTuple

from numba import types

IMAGE, SUMS = types.uint8[:, :, ::1], types.uint16[:, :, ::1]
WORDS, MAP, WHITE = types.uint32[::1], types.int32[:, ::1], types.boolean[:, ::1]
NNF, DELTA = types.int32[:, :, ::1], types.int64[:, ::1]
INT, STREAM = types.int64, types.UniTuple(types.uint32, 4)
NUMBERS, TOTALS = types.int64[::1], types.int64[:, ::1]
METRIC = WORDS, WORDS, NUMBERS, WHITE, SUMS, SUMS
SEARCH = *METRIC, MAP, INT, NNF, DELTA, NNF, DELTA
COMMITMENT = NNF, DELTA, NNF, DELTA, MAP, INT


class Sizes(NamedTuple):
    """The sizes that kernels are compiled for; by default those of the thesis.

    Attributes
    ----------
    block : (int, int)
        Threads of a block along x and y.
    patch_width, channels, style_channels, guide_channels : int
    """

    block: tuple[int, int]
    patch_width: int = 5
    channels: int = 32
    style_channels: int = 3
    guide_channels: int = 16
