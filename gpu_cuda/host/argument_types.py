"""Types of kernels' arguments, and the sizes for which a kernel is compiled where none is given.

A module with kernels says how they are compiled without a device: its function ``kernels(sizes)``
gives the name, the kernel and the types of its arguments, of each (:mod:`gpu_cuda.host.ptx`).
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
    """What kernels are compiled for: the thesis' sizes by default.

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
