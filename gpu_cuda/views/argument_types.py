"""Types of the arrays that these kernels take."""

from numba import types

FIELD, PLACES = types.float32[:, :, ::1], types.int32[:, :, ::1]
FLAGS, DEPTH, INVERSE = types.boolean[:, ::1], types.float32[:, ::1], types.float64[:, ::1]
